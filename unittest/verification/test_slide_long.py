# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The block of test_slide.py pressed without friction on a finer lattice, and, as figures without
bars, by the law of contact of the paper, which depends on the time step."""

from scenes.slide import Slide, compressed
from tmsph_testing import main


def fine(report):
    compressed(report, 40)


def law_of_the_paper(report):
    paper = [Slide(law="paper", cfl=cfl) for cfl in (0.5, 0.25)]
    report.note("law paper: normal force before sliding, dt and dt/2, of exact",
                " ".join(f"{s.pressed / s.exact():.4f}" for s in paper))
    report.note("law paper: friction/normal force", " ".join(
        f"{s.friction[s.slides].mean() / s.normal[s.slides].mean():.4f}" for s in paper))


if __name__ == "__main__":
    main(fine, law_of_the_paper)
