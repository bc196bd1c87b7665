# SPDX-License-Identifier: GPL-3.0-or-later

option(BORESIGHT_UNIT_TESTS "Build the tests that the presets with sanitizers run (labels unit and ui), too" ON)

# How much of what ctest --parallel counts a test takes that computes. A test that waits for programs in slow time takes 1.
set(BORESIGHT_COMPUTES 3)

set(BORESIGHT_TEST_RESULTS "${CMAKE_BINARY_DIR}/test-results")  # one XML file of GoogleTest for each test of ctest

# The line numbers of tests cost a tenth of their compilation, and a failure names its line without them. Only the preset
# dev has them, for a debugger.
set(test_options -O0)
if(BORESIGHT_UNITY)
  list(APPEND test_options -g0)
endif()

# boresight_add_test(NAME LABEL unit|ui|system|long SOURCES … [LIBRARIES …])
# A GoogleTest program, which is one test of ctest: it runs from its first to its last case. LIBRARIES is what is tested,
# boresight_core if it is not said. The label says where it runs, so that nothing runs twice without need:
#   unit, ui    with the sanitizers: of classes, of a station in one process, and of the window
#   system      with the sanitizers and in the release build: of whole programs, and of the window before a real station
#   long        in the release build: its cases take the paths of others again, for hours of simulated time, with other
#               fonts or in other themes
#   QT_MAIN     its main() has a QCoreApplication; OWN_MAIN: it brings a main() of its own
#   ONE_THREAD  ThreadSanitizer has nothing to find in it, or nothing that another test does not show: left out there
#   SHARDS n    a long one, run as n tests of ctest beside each other
#   TIMEOUT s   of each; 600 s if it is not said
#   SLOW_TIME   its programs must keep the watchdog of a drive: their time passes slower (tests/system/programs/slow_clock.cpp)
#   FOLDERS_TOGETHER  its sources lie in many small folders (boresight_unite)
#   HEADERS_OF  station or ui: shares the headers that tests/CMakeLists.txt precompiles for programs before a whole station
#               or for those of the window
#   OPTIMISED   for a long one; tests are not, for what they test is, and half of a build from nothing goes into them
function(boresight_add_test name)
  cmake_parse_arguments(T "QT_MAIN;OWN_MAIN;ONE_THREAD;SLOW_TIME;OPTIMISED;FOLDERS_TOGETHER" "LABEL;TIMEOUT;SHARDS;HEADERS_OF"
    "SOURCES;LIBRARIES" ${ARGN})
  if((T_ONE_THREAD AND BORESIGHT_SANITIZE MATCHES "thread") OR (T_LABEL STREQUAL "long" AND BORESIGHT_SANITIZE)
      OR (T_LABEL MATCHES "unit|ui" AND NOT BORESIGHT_UNIT_TESTS))
    return()
  endif()
  if(NOT T_LIBRARIES)
    set(T_LIBRARIES boresight_core)
  endif()
  set(main GTest::gmock_main)
  if(T_QT_MAIN)
    set(main boresight_qt_main)
  elseif(T_OWN_MAIN)
    set(main "")
  endif()
  add_executable(${name} ${T_SOURCES})
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  target_link_libraries(${name} PRIVATE boresight_fakes ${T_LIBRARIES} Qt6::Test ${main} GTest::gmock)
  set(together "")
  if(T_FOLDERS_TOGETHER)
    set(together FOLDERS_TOGETHER)
  endif()
  boresight_unite(${name} ${together})
  if(T_OPTIMISED)
    target_compile_options(${name} PRIVATE -O1)
    boresight_precompile(${name} ${test_headers})
  else()
    target_compile_options(${name} PRIVATE ${test_options})
    string(JOIN _ headers boresight ${T_HEADERS_OF} test_headers)
    target_precompile_headers(${name} REUSE_FROM ${headers})
  endif()
  target_compile_definitions(${name} PRIVATE BORESIGHT_TEST_DATA="${CMAKE_SOURCE_DIR}/tests/data")
  if(T_SLOW_TIME)
    add_dependencies(${name} slow_clock)
  endif()
  boresight_add_runs(${name} "${T_LABEL}" "${T_SHARDS}" "${T_TIMEOUT}" "${T_SLOW_TIME}")
endfunction()

# boresight_test_headers(NAME LIBRARIES … HEADERS …): compiled once for many test programs, by a program that is never run,
# for it has to be compiled as they are.
function(boresight_test_headers name)
  cmake_parse_arguments(H "" "" "LIBRARIES;HEADERS" ${ARGN})
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "int main()\n{}\n")
  add_executable(${name} EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  target_link_libraries(${name} PRIVATE ${H_LIBRARIES} GTest::gmock)
  target_compile_options(${name} PRIVATE ${test_options})
  boresight_precompile(${name} ${test_headers} ${H_HEADERS})
endfunction()

# Tests that run at the same time do not find each other's settings.
function(boresight_give_home run)
  foreach(kind CONFIG DATA STATE CACHE)
    set_property(TEST ${run} APPEND PROPERTY
      ENVIRONMENT "XDG_${kind}_HOME=${CMAKE_BINARY_DIR}/test-home/${run}/${kind}")
  endforeach()
endfunction()

# For a program with SDL: lsan.supp knows a leak of it by who allocated, which takes too long to be noted everywhere.
function(boresight_note_allocations run)
  if(TEST ${run})
    set_property(TEST ${run} APPEND PROPERTY ENVIRONMENT_MODIFICATION
      "ASAN_OPTIONS=string_append::malloc_context_size=2")
  endif()
endfunction()

# Those of label system wait for programs that keep real time: the others reckon behind them.
function(boresight_add_runs name label shards timeout slow_time)
  if(NOT shards)
    set(shards 1)
  endif()
  if(NOT timeout)
    set(timeout 600)
  endif()
  foreach(i RANGE 1 ${shards})
    set(run ${name})
    if(shards GREATER 1)
      set(run ${name}.${i})
    endif()
    math(EXPR index "${i} - 1")
    set(command $<TARGET_FILE:${name}>)
    if(NOT label STREQUAL "system")
      list(PREPEND command nice -n 10)
    endif()
    add_test(NAME ${run} COMMAND ${command} "--gtest_output=xml:${BORESIGHT_TEST_RESULTS}/${run}.xml")
    set_tests_properties(${run} PROPERTIES LABELS "${label}" TIMEOUT ${timeout}
      ENVIRONMENT "GTEST_TOTAL_SHARDS=${shards};GTEST_SHARD_INDEX=${index}")
    boresight_give_home(${run})
    if(NOT slow_time)
      set_tests_properties(${run} PROPERTIES PROCESSORS ${BORESIGHT_COMPUTES})
    else()
      set_tests_properties(${run} PROPERTIES COST 1500)  # first: they wait longest
      # AddressSanitizer wants to be loaded first, and the order makes no difference to it.
      set_property(TEST ${run} APPEND PROPERTY ENVIRONMENT_MODIFICATION
        "LD_PRELOAD=set:$<TARGET_FILE:slow_clock>"
        "ASAN_OPTIONS=string_append::verify_asan_link_order=0")
    endif()
    if(shards GREATER 1 AND NOT slow_time)
      set_tests_properties(${run} PROPERTIES COST 1000)  # early, or the last core is alone with them
    endif()
  endforeach()
endfunction()
