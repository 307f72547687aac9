# SPDX-License-Identifier: MIT
# cmake -DPROGRAM=... -DPREFIX=... -DLABEL=... -DTIMEOUT=... -DOUT=... -P discover_suites.cmake: writes add_test() for each suite of a GoogleTest program, so
# that what the tests of a suite share is made once, and not in a process per test.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed TIMEOUT 120)
if(failed)
  message(FATAL_ERROR "${PROGRAM} does not list its tests: ${failed}")
endif()
string(REPLACE ";" "\\;" listed "${listed}")
string(REPLACE "\n" ";" lines "${listed}")
set(tests "")
set(found 0)
foreach(line IN LISTS lines)
  # Suites begin a line and end with a dot; a comment may follow. Their tests are indented.
  if(NOT line MATCHES "^([^ ]+)\\.( |$)")
    continue()
  endif()
  set(suite ${CMAKE_MATCH_1})
  string(APPEND tests "add_test([==[${PREFIX}.${suite}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.*]==])\n"
    "set_tests_properties([==[${PREFIX}.${suite}]==] PROPERTIES TIMEOUT ${TIMEOUT} SKIP_RETURN_CODE 77 LABELS [==[${LABEL}]==])\n")
  math(EXPR found "${found} + 1")
endforeach()
if(found EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} has no tests")
endif()
file(WRITE ${OUT} "${tests}")
