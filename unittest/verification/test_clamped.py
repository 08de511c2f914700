# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Homogeneous states with closed forms, for stress, potential energy and the
pressure that LAMMPS gets from the virial: clamped and half-clamped heating,
and finite strain without heat. The lattice is regular, so every particle is in
equilibrium where it stands and the values are exact up to round-off."""

import numpy as np

from scenes.clamped import ALPHA, E, NU, STATES, STRESSES, State, Wavy
from tmsph_testing import main, order

SCATTER = 1e-7    # positions of 10 spacings rounded to 2^-53, over a strain of 1e-7, is 1e-8


def relative(value, exact):
    return abs(value / exact - 1)


def blocked(report):
    """No displacement at all; expansion 1e-7, so that the linear values hold to about 1e-6."""
    dT = 1e-2
    linear = {"plane strain": -E * ALPHA * dT / (1 - 2 * NU),
              "plane stress": -E * ALPHA * dT / (1 - NU),
              "3-D": -E * ALPHA * dT / (1 - 2 * NU)}
    for plane, exact in linear.items():
        for mode in ("bond", "strain"):
            what = f"blocked, {plane}, thermal {mode}"
            s = State(plane, "xyz"[: 3 if plane == "3-D" else 2], dT, options=f"thermal {mode}")
            axes = ("sxx", "syy") if plane == "plane stress" else ("sxx", "syy", "szz")
            error = max(relative(s.stress[a], exact) for a in axes)
            report.below(f"{what}: error of the stress", error, 1e-6)
            if plane == "plane stress":
                report.true(f"{what}: no stress out of plane", s.stress["szz"] == 0, "exactly")
            report.below(f"{what}: scatter/stress", s.spread / abs(exact), SCATTER)
            report.below(f"{what}: error of the pressure", relative(s.pressure, -exact), 1e-6)
            report.below(f"{what}: force/(E dx)", s.force, 1e-14)


def half_blocked(report):
    """Periodic in x, free sides moved to where they carry no stress: uniaxial stress."""
    dT = 1e-2
    for plane, exact, sides in [("plane strain", -E * ALPHA * dT / (1 - NU), (1 + NU) / (1 - NU)),
                                ("plane stress", -E * ALPHA * dT, 1 + NU),
                                ("3-D", -E * ALPHA * dT, 1 + NU)]:
        s = State(plane, "x", dT, [1.0] + [1 + sides * ALPHA * dT] * (2 if plane == "3-D" else 1))
        what = f"half blocked, {plane}"
        report.below(f"{what}: error of sxx", relative(s.stress["sxx"], exact), 1e-6)
        report.below(f"{what}: syy/sxx", abs(s.stress["syy"] / exact), 1e-6)
        out = exact if plane == "plane strain" else 0.0
        report.below(f"{what}: error of szz/sxx", abs((s.stress["szz"] - out) / exact), 1e-6)
        report.below(f"{what}: scatter/stress", s.spread / abs(exact), SCATTER)
        report.below(f"{what}: force/(sxx dx)", s.force * E / abs(exact), 1e-6)


def finite(report):
    """Stretches of several percent, hot or cold: St Venant-Kirchhoff in closed form.
    With the thermal bond the elastic stretch is the stretch over 1 + a."""
    for plane in STATES:
        for T in (0.0, 3000.0):
            d = 3 if plane == "3-D" else 2
            stretch = np.array([1.1, 0.95, 1.03][:d])
            s = State(plane, "xyz"[:d], T, stretch)
            what = f"finite strain, {plane}, {'hot' if T else 'cold'}"
            elastic = stretch / (1 + s.expansion * T)
            strain = (elastic**2 - 1) / 2
            S = s.second_piola(strain)
            report.below(f"{what}: error of the energy",
                         relative(s.energy, s.V * 0.5 * np.dot(S, strain)), 1e-12)
            kirchhoff = elastic**2 * S    # per reference volume
            pressures = -kirchhoff * s.V / s.volume
            error = np.abs(np.array(s.tensor[:d]) - pressures).max() / np.abs(pressures).max()
            report.below(f"{what}: error of the virial", error, 1e-12)
            report.below(f"{what}: error of the pressure",
                         relative(s.pressure, pressures.mean()), 1e-12)
            cauchy = kirchhoff / np.prod(stretch)
            error = max(relative(s.stress[a], c) for a, c in zip(STRESSES, cauchy))
            if T:    # stress is per area of the body as it has expanded: (1 + a)^d more
                report.note(f"{what}: stress/Cauchy stress - 1", f"{error:.4g}")
            else:
                report.below(f"{what}: error of the stress", error, 1e-12)


def wavy(report):
    """Heating by 1 + cos(k x): of second order."""
    for plane in STATES:
        errors = [Wavy(plane, n).error for n in (20, 40)]
        report.note(f"wavy heating, {plane}: error of the stress at 20, 40 particles",
                    np.round(errors, 5))
        report.within(f"wavy heating, {plane}: order", order(errors)[0], 1.9, 2.2)


if __name__ == "__main__":
    main(blocked, half_blocked, finite, wavy)
