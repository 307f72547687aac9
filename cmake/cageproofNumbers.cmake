# SPDX-License-Identifier: MIT
# MPFR and GMP, which ship no CMake package, as cageproof::mpfr and cageproof::gmp; part of the build, and installed for those who link the library.
# The static libraries where they are installed: every operation reads MPFR's thread-local settings, which a shared library
# must look up, and multiprecision evaluations take a sixth longer. FLINT and Arb bring the shared ones as well; they
# exchange numbers with the program, never settings.
find_library(MPFR_LIBRARY NAMES libmpfr.a mpfr)
find_library(GMP_LIBRARY NAMES libgmp.a gmp)
set(scope)
if(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL)
  set(scope GLOBAL)
endif()
foreach(number mpfr gmp)
  string(TOUPPER ${number} upper)
  if(${upper}_LIBRARY AND NOT TARGET cageproof::${number})
    add_library(cageproof::${number} UNKNOWN IMPORTED ${scope})
    set_target_properties(cageproof::${number} PROPERTIES IMPORTED_LOCATION "${${upper}_LIBRARY}")
  endif()
endforeach()
