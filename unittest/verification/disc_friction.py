# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What friction at the interface changes in the heated disc (Mu et al. 2022, Sect. 5.3): a
table for bonded inclusions and for those that only touch, with friction 0, 0.3 and 0.6, for
three draws of the strengths. A study, without bars; some minutes:
    TMSPH_LMP=$(./tmsph where) /usr/bin/python3 unittest/verification/disc_friction.py"""

from test_disc_cracks import SEEDS, SPACING, Disc


def row(seed, friction):
    disc = Disc(seed, friction=friction)
    sides = " | ".join("/".join(f"{1e3 * disc.crack_length(T, side):.0f}" for side in (-1, 1))
                       for T in (160, 230, 260))
    name = "bonded" if friction is None else f"friction {friction}"
    print(f"| {name} | {seed} | {disc.T.min():.1f} | {disc.temperature_at(disc.a + 0.005):.0f} "
          f"| {disc.temperature_at(disc.R - 2 * SPACING):.0f} | {disc.main_cracks()} "
          f"| {len(disc.T)} | {sides} |", flush=True)


if __name__ == "__main__":
    print("| interface | draw | first break, C | 5 mm, C | rim, C | main cracks | bonds broken "
          "| left/right at 160, mm | at 230 | at 260 |")
    print("|" + "---|" * 10)
    for friction in [None, 0.0, 0.3, 0.6]:
        for seed in SEEDS:
            row(seed, friction)
