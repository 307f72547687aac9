# SPDX-License-Identifier: MIT
# What every room's CMakeLists.txt uses: one flag set, one way to declare a room, one way to declare its tests.

add_library(cageproof_flags INTERFACE)
target_compile_options(cageproof_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-float-conversion -Werror
  # GCC 12 sees overflows in std::string's own operator+ when it inlines Boost.Multiprecision's printing.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  # Error-free transformations need each operation rounded on its own.
  -ffp-contract=off)
if(CAGEPROOF_SANITIZE)
  target_compile_options(cageproof_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(cageproof_flags INTERFACE -fsanitize=address,undefined)
endif()

# cageproof_room(NAME LINK libs...): the room's src/**.cpp as an object library, so that rows which register themselves are kept.
function(cageproof_room name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp)
  add_library(cageproof_${name} OBJECT ${sources})
  target_include_directories(cageproof_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(cageproof_${name} PUBLIC ${ARG_LINK} PRIVATE cageproof_flags)
  # Eigen and Boost.Multiprecision cost 5 s a file without it.
  target_precompile_headers(cageproof_${name} PRIVATE <cageproof/core/linear.h>)
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# cageproof_tests(NAME LINK rooms...): every tests/*.cpp of the room in one GoogleTest binary.
function(cageproof_tests name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/tests/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_tests ${sources})
  target_link_libraries(${name}_tests PRIVATE ${ARG_LINK} cageproof_flags GTest::gtest GTest::gtest_main)
  target_precompile_headers(${name}_tests PRIVATE <cageproof/core/linear.h> <gtest/gtest.h>)
  target_compile_definitions(${name}_tests PRIVATE
    CAGEPROOF_SHARED_DATA="${CMAKE_SOURCE_DIR}/../shared/data")
  gtest_discover_tests(${name}_tests TEST_PREFIX ${name}. DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT 900)
endfunction()
