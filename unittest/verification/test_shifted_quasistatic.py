# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Shifted bodies that break in equilibrium, in all ways at all places, see test_shifted.py."""

from test_shifted import Quasistatic, Report, shifted

report = Report()
shifted(report, Quasistatic, True)
report.finish()
