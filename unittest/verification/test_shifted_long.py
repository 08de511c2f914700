# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Shifted bodies that break in equilibrium, see test_shifted.py. In 3-D other bonds were seen to break
across edges and corners after a restart or a balance: not mended yet."""

from test_shifted import Quasistatic, Report, shifted

report = Report()
shifted(report, Quasistatic, True)
report.finish()
