# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
# For "make yes-tmsph" of LAMMPS's traditional build, which has no place for the package's needs.

[ "$1" = 0 ] || echo "TMSPH cannot be built by traditional make: use its ./tmsph, or CMake as its README says" >&2
exit "$1"
