# SPDX-License-Identifier: GPL-3.0-or-later
include(GoogleTest)

# boresight_add_test(NAME LABEL unit|ui|system SOURCES … LIBRARIES …)
# One GoogleTest executable per module. LIBRARIES is what is tested (boresight_core or boresight_ui); NO_MAIN leaves
# out GTest's main for tests that bring their own (a QCoreApplication or QApplication). SERIAL is for tests that measure
# real time: nothing else runs beside them. ONE_THREAD is for tests in which ThreadSanitizer has nothing to find, or
# nothing that a test beside them does not show: its build leaves them out. All share one precompiled header; HEADERS
# gives an executable one of its own, with these besides the usual.
#
# Tests are not optimised: what they test is, and half of the time of a build from nothing goes into them.
function(boresight_add_test name)
  cmake_parse_arguments(T "NO_MAIN;SERIAL;ONE_THREAD" "LABEL;TIMEOUT" "SOURCES;LIBRARIES;HEADERS" ${ARGN})
  if(T_ONE_THREAD AND BORESIGHT_SANITIZE MATCHES "thread")
    return()
  endif()
  if(T_SERIAL)
    set(serial TRUE)
  else()
    set(serial FALSE)
  endif()
  if(NOT T_TIMEOUT)
    set(T_TIMEOUT 120)
  endif()
  add_executable(${name} ${T_SOURCES})
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  if(T_NO_MAIN)
    target_link_libraries(${name} PRIVATE ${T_LIBRARIES} GTest::gmock)
  else()
    target_link_libraries(${name} PRIVATE ${T_LIBRARIES} GTest::gmock_main)
  endif()
  target_compile_options(${name} PRIVATE -O0)
  boresight_unite(${name})
  if(T_HEADERS)
    boresight_precompile(${name} ${test_headers} ${T_HEADERS})
  else()
    target_precompile_headers(${name} REUSE_FROM boresight_test_headers)
  endif()
  target_compile_definitions(${name} PRIVATE BORESIGHT_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/data")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${T_LABEL}" TIMEOUT ${T_TIMEOUT}
    RUN_SERIAL ${serial})
endfunction()
