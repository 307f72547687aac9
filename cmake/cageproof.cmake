# SPDX-License-Identifier: MIT
# Functions for every room's CMakeLists.txt: one flag set, one way to declare a room, one way to declare its tests.

add_library(cageproof_flags INTERFACE)
# Other projects' compilers may warn of more.
set(errors -Werror)
if(CAGEPROOF_LIBRARY_ONLY)
  set(errors)
endif()
target_compile_options(cageproof_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-float-conversion ${errors}
  # Nobody replaces functions of the shared library, so GCC may inline them.
  $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
  # GCC 12 sees overflows in std::string's own operator+ when it inlines Boost.Multiprecision's printing.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>
  # The stored worst cases are one long literal.
  -Wno-overlength-strings
  # Error-free transformations need each operation rounded on its own.
  -ffp-contract=off
  # The linker can then leave functions that nobody calls out of the shared library.
  $<$<BOOL:${CAGEPROOF_LIBRARY_ONLY}>:-ffunction-sections> $<$<BOOL:${CAGEPROOF_LIBRARY_ONLY}>:-fdata-sections>)
if(CAGEPROOF_SANITIZE STREQUAL address)
  # Null and misaligned members are checked at every access, which doubles the build; a null one faults under the address sanitizer anyway. So do, for Clang,
  # virtual tables, and sizes and overflows of pointers, which the address sanitizer sees where memory is touched.
  set(unchecked null,alignment$<$<CXX_COMPILER_ID:Clang>:,vptr,function,pointer-overflow,object-size>)
  target_compile_options(cageproof_flags INTERFACE -fsanitize=address,undefined -fno-sanitize=${unchecked} -fno-sanitize-recover=all
    -fno-omit-frame-pointer
    # Accesses are checked by calls: a quarter less to compile, and most of a run's time is MPFR's anyway.
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-address-outline-instrumentation>)
  # Indices of the standard library's arrays, which the sanitizers do not see where there is memory behind them.
  target_compile_definitions(cageproof_flags INTERFACE _GLIBCXX_ASSERTIONS)
  target_link_options(cageproof_flags INTERFACE -fsanitize=address,undefined)
  if(CAGEPROOF_FUZZ)
    # Tells libFuzzer which branches an input took.
    target_compile_options(cageproof_flags INTERFACE -fsanitize=fuzzer-no-link)
  endif()
elseif(CAGEPROOF_SANITIZE STREQUAL thread)
  target_compile_options(cageproof_flags INTERFACE -fsanitize=thread)
  target_link_options(cageproof_flags INTERFACE -fsanitize=thread)
elseif(CAGEPROOF_SANITIZE)
  message(FATAL_ERROR "CAGEPROOF_SANITIZE is '${CAGEPROOF_SANITIZE}': address or thread")
endif()

# ccache, where it is installed, takes from its store what was compiled before from the same text. It learns from the compiler what a source includes;
# a precompiled header must hold no time, or it would be another one each time.
find_program(CCACHE ccache)
if(CCACHE AND CMAKE_CXX_COMPILER_ID STREQUAL Clang AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>")
endif()

# cageproof_room(NAME LINK libs... [PRECOMPILE <header>...] [HEADERS_OF target] [BATCH n | BY_FOLDER] [INSTANCES regex]): the room's
# src/**.cpp as an object library, so that rows which register themselves are kept. PRECOMPILE: what most of its files include besides
# vectors and evaluations. HEADERS_OF: takes that target's precompiled headers, which must have the same definitions,
# instead of its own. Of a unity build: BATCH files are compiled at once, or BY_FOLDER those of each folder, which instantiate the same
# templates. INSTANCES: files that instantiate what others declare extern; beside them others would instantiate it again, for inlining.
function(cageproof_room name)
  cmake_parse_arguments(ARG "BY_FOLDER" "HEADERS_OF;BATCH;INSTANCES" "LINK;PRECOMPILE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp)
  add_library(cageproof_${name} OBJECT ${sources})
  # The files of an element's kind say the same things of different kinds, in the same words.
  set(of_kinds ${sources})
  list(FILTER of_kinds INCLUDE REGEX "/src/(element|geometry)/(table.cpp|(quad|segment|triangle)/)")
  set_source_files_properties(${of_kinds} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  if(ARG_INSTANCES)
    set(instances ${sources})
    list(FILTER instances INCLUDE REGEX "${ARG_INSTANCES}")
    set_source_files_properties(${instances} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  if(ARG_BATCH)
    set_target_properties(cageproof_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE ${ARG_BATCH})
  elseif(ARG_BY_FOLDER)
    foreach(source ${sources})
      cmake_path(GET source PARENT_PATH folder)
      cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
      string(MAKE_C_IDENTIFIER ${folder} group)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
    endforeach()
    set_target_properties(cageproof_${name} PROPERTIES UNITY_BUILD_MODE GROUP)
  endif()
  target_include_directories(cageproof_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(cageproof_${name} PUBLIC ${ARG_LINK} PRIVATE cageproof_flags)
  # Reading headers is a quarter of a build, and five seconds a file, without it.
  # GCC takes a precompiled header only with the very definitions that it was made with, so there each room has its own.
  if(ARG_HEADERS_OF AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    target_precompile_headers(cageproof_${name} REUSE_FROM ${ARG_HEADERS_OF})
  else()
    target_precompile_headers(cageproof_${name} PRIVATE <cageproof/core/numbers/linear.h> <cageproof/core/catalogue/evaluation.h> <fmt/format.h> <filesystem>
      <cageproof/core/coordinates/coordinates.h> ${ARG_PRECOMPILE})
  endif()
endfunction()

# cageproof_forms(TARGET ROOM ELEMENT INCLUDE REGISTER CLASS): registers in TARGET what ROOM makes of each closed form on an element. Each header
# INCLUDE/cageproof/closed_form/<element>/<kernel>.h has a struct of its name in capitals; a source is written that says of it
# `const CLASS<Kernel> registered{"<element>.<kernel>"};`, with CLASS from the header REGISTER.
function(cageproof_forms target room element include register class)
  set(folder cageproof/closed_form/${element})
  file(GLOB headers CONFIGURE_DEPENDS ${include}/${folder}/*.h)
  set(group 0)
  foreach(header ${headers})
    cmake_path(GET header STEM kernel)
    math(EXPR group "(${group} + 1) % 3")
    set(form "")
    string(REPLACE "_" ";" words ${kernel})
    foreach(word ${words})
      string(SUBSTRING ${word} 0 1 first)
      string(SUBSTRING ${word} 1 -1 rest)
      string(TOUPPER ${first} first)
      string(APPEND form ${first}${rest})
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${room}/${element}/${kernel}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "// Written by cageproof_forms.
#include \"${folder}/${kernel}.h\"

#include \"${register}\"

namespace cageproof::${room}::${element} {
namespace {

const ${class}<closed_form::${element}::${form}> register_${kernel}{\"${element}.${kernel}\"};

}  // namespace
}  // namespace cageproof::${room}::${element}
")
    target_sources(${target} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP forms_${room}_${element}_${group})
  endforeach()
endfunction()

# cageproof_all_forms(TARGET INCLUDE): the closed forms in a folder of headers, in every room that registers some.
function(cageproof_all_forms target include)
  foreach(element triangle segment)
    cageproof_forms(${target} closed_form ${element} ${include} ${PROJECT_SOURCE_DIR}/closed_form/src/${element}/engine/register_form.h RegisterForm)
    cageproof_forms(${target} fast ${element} ${include} ${PROJECT_SOURCE_DIR}/fast/src/${element}/register_hybrid.h RegisterHybrid)
  endforeach()
endfunction()

# cageproof_tests(NAME LINK rooms... [LABELS label...] [UNITY] [OPTIMISED]): every tests/*.cpp of the room in one GoogleTest program, and a test of CTest per suite. Tests
# labelled `memory` also run under the address sanitizer, and `threads` under the thread sanitizer. UNITY: in a unity build eight sources are compiled at once,
# which halves the time, because tests instantiate the same templates. Names in anonymous namespaces meet there: a source whose names another one has puts
# them into a namespace of its own.
# Tests are compiled without optimisation, in half the time or less. What both they and a room instantiate is the room's, as users get it: the linker takes the
# first copy, and rooms are linked first. OPTIMISED: tests that compute for longer than they take to compile.
function(cageproof_tests name)
  cmake_parse_arguments(ARG "UNITY;OPTIMISED" "" "LINK;LABELS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/tests/*.cpp)
  if(NOT sources OR CAGEPROOF_LIBRARY_ONLY)
    return()
  endif()
  add_library(${name}_test_objects OBJECT ${sources})
  # Sources without a group are compiled one by one.
  set_target_properties(${name}_test_objects PROPERTIES UNITY_BUILD_MODE GROUP)
  if(ARG_UNITY)
    set(count 0)
    foreach(source ${sources})
      math(EXPR group "${count} / 8")
      math(EXPR count "${count} + 1")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP tests_${group})
    endforeach()
  endif()
  target_link_libraries(${name}_test_objects PRIVATE ${ARG_LINK} cageproof_flags GTest::gtest)
  target_include_directories(${name}_test_objects PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/cmake)
  if(NOT ARG_OPTIMISED)
    target_compile_options(${name}_test_objects PRIVATE -O0)
  endif()
  # GCC takes a precompiled header only with the very definitions that it was made with; core's tests come first.
  if(CMAKE_CXX_COMPILER_ID STREQUAL Clang AND NOT name STREQUAL core AND NOT ARG_OPTIMISED)
    target_precompile_headers(${name}_test_objects REUSE_FROM core_test_objects)
  else()
    target_precompile_headers(${name}_test_objects PRIVATE <cageproof/core/numbers/linear.h> <gtest/gtest.h>)
  endif()
  target_compile_definitions(${name}_test_objects PRIVATE
    CAGEPROOF_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
  add_executable(${name}_tests ${PROJECT_SOURCE_DIR}/cmake/test_main.cpp)
  target_link_libraries(${name}_tests PRIVATE ${ARG_LINK} ${name}_test_objects cageproof_flags GTest::gtest)
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${name}_suites.cmake)
  add_custom_command(TARGET ${name}_tests POST_BUILD BYPRODUCTS ${suites} COMMENT ""
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${name}_tests> -DPREFIX=${name} "-DLABEL=${ARG_LABELS}" -DTIMEOUT=900 -DOUT=${suites}
      -P ${PROJECT_SOURCE_DIR}/cmake/discover_suites.cmake)
  # A program that is not built has not run its tests.
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}_tests.cmake
    "if(EXISTS [==[${suites}]==])\n  include([==[${suites}]==])\nelse()\n  add_test([==[${name}_tests.NOT_BUILT]==] [==[${name}_tests.NOT_BUILT]==])\n"
    "  set_tests_properties([==[${name}_tests.NOT_BUILT]==] PROPERTIES LABELS [==[${ARG_LABELS}]==])\nendif()\n")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${name}_tests.cmake)
endfunction()
