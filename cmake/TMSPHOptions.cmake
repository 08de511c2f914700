# TMSPH_OPTIONS: what the sources of the package are compiled with, in LAMMPS, as a plugin and in tests.

include(CheckCXXSourceCompiles)

# a square root that need not set errno can be taken of eight numbers at once
set(TMSPH_OPTIONS -fno-math-errno)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND TMSPH_OPTIONS -Wno-psabi)   # no function of eight numbers is called across files
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  list(APPEND TMSPH_OPTIONS -Wno-maybe-uninitialized)   # of GCC's own headers for AVX-512 (its bug 105593)
endif()

# Where a register holds fewer than eight numbers the compiler treats parts of them one by one, and may round
# a*b + c once in one part and twice in the other. The forces of a particle would depend on its place in the
# arrays, and so on the number of processes (unittest/physics/test_sweep.cpp).
set(CMAKE_REQUIRED_FLAGS)
if(TMSPH_NATIVE)
  set(CMAKE_REQUIRED_FLAGS -march=native)
endif()
check_cxx_source_compiles("#ifndef __AVX512F__\n#error\n#endif\nint main() {}" TMSPH_HAVE_AVX512)
unset(CMAKE_REQUIRED_FLAGS)
if(NOT TMSPH_HAVE_AVX512)
  list(APPEND TMSPH_OPTIONS -ffp-contract=off)
endif()
