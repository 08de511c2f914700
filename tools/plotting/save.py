# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Writes a picture with as many colours as it needs: small files."""
import io

from matplotlib import pyplot as plt
from PIL import Image

from lammps_files import stop

DPI, COLOURS = 120, 96


def save(figure, path):
    buffer = io.BytesIO()
    figure.savefig(buffer, dpi=DPI, format="png", bbox_inches="tight", pad_inches=0.08)
    plt.close(figure)
    picture = Image.open(buffer).convert("RGB")
    try:
        picture.quantize(COLOURS, dither=Image.Dither.NONE).save(path, optimize=True)
    except OSError as error:
        stop(f"cannot write {path}: {error.strerror}")
    print(path)
