# SPDX-License-Identifier: MIT
# libcageproof.so: everything behind the C interface. Its objects are those of the archives: within the library all names are local
# (exports.map), so that code for position-independent programs, which Clang makes unasked, will do for all but thread-local data.
# MPFR and GMP are shared ones, because static ones keep thread-local settings that a library cannot have.
if(CAGEPROOF_MPFR)
  find_library(MPFR_SHARED_LIBRARY NAMES libmpfr.so mpfr REQUIRED)
  find_library(GMP_SHARED_LIBRARY NAMES libgmp.so gmp REQUIRED)
endif()
# Its loops know by a thread-local flag whether they lie within others.
set_property(SOURCE ${PROJECT_SOURCE_DIR}/core/src/parallel.cpp TARGET_DIRECTORY cageproof_core APPEND PROPERTY COMPILE_OPTIONS -fPIC)
set(exports ${CMAKE_CURRENT_SOURCE_DIR}/exports.map)
set(shared_objects)
foreach(room library fast deformation solved adaptive_qmvc closed_form core)
  list(APPEND shared_objects $<TARGET_OBJECTS:cageproof_${room}>)
endforeach()
add_library(cageproof_shared SHARED ${shared_objects})
set_target_properties(cageproof_shared PROPERTIES OUTPUT_NAME cageproof EXPORT_NAME shared VERSION ${PROJECT_VERSION} SOVERSION 1
  LINKER_LANGUAGE CXX LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib LINK_DEPENDS ${exports})
target_link_options(cageproof_shared PRIVATE -Wl,--version-script=${exports} -Wl,--no-undefined -Wl,--as-needed -Wl,--gc-sections)
target_link_libraries(cageproof_shared PRIVATE fmt::fmt $<$<BOOL:${CAGEPROOF_NLOPT}>:NLopt::nlopt> ${MPFR_SHARED_LIBRARY} ${GMP_SHARED_LIBRARY} $<$<BOOL:${CAGEPROOF_TBB}>:TBB::tbb>)
target_include_directories(cageproof_shared INTERFACE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
add_library(cageproof::shared ALIAS cageproof_shared)
if(NOT CAGEPROOF_LIBRARY_ONLY)
  install(TARGETS cageproof_shared EXPORT cageproofTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
endif()
