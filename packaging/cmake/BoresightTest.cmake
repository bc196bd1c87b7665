# SPDX-License-Identifier: GPL-3.0-or-later

option(BORESIGHT_UNIT_TESTS "Build the tests that the presets with sanitizers run (labels unit and ui), too" ON)

# The share of a test that computes, in the units of ctest --parallel. A test that waits for programs in slow time has
# 1.
set(BORESIGHT_COMPUTES 3)

set(BORESIGHT_TEST_RESULTS "${CMAKE_BINARY_DIR}/test-results")  # one XML file of GoogleTest for each test of ctest

# Line numbers for a debugger take a tenth of the time to compile a test. A failed check names its line without them.
# Only the preset dev has them.
set(test_options -O0)
if(BORESIGHT_UNITY)
  list(APPEND test_options -g0)
endif()

# boresight_join_test(PROGRAM SOURCE…)
# The tests of a folder become a part of a program that boresight_add_test() adds later: half of a build from nothing
# compiles tests, and each program of its own compiles the same headers again and is linked.
function(boresight_join_test program)
  list(TRANSFORM ARGN PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set_property(GLOBAL APPEND PROPERTY BORESIGHT_JOINED_${program} ${ARGN})
endfunction()

# boresight_add_test(NAME LABEL unit|ui|system|long [SOURCES …] [LIBRARIES …])
# A GoogleTest program, of these sources and those that joined it. It is one test of ctest, which runs all its cases. LIBRARIES are the tested libraries (default:
# boresight_core). The label decides in which builds the test runs, so that no test runs twice without need:
#   unit, ui    with the sanitizers. Tests of classes, of a station in one process, and of the window
#   system      with the sanitizers and in the release build. Tests of whole programs, and of the window with a real station
#   long        in the release build. Cases that repeat others for hours of simulated time, with other fonts or themes
#   QT_MAIN     main() has a QCoreApplication
#   OWN_MAIN    the test has its own main()
#   ONE_THREAD  not under ThreadSanitizer, because the test has one thread, or because another test shows the same races
#   SHARDS n    a long test, run as n tests of ctest at the same time
#   TIMEOUT s   of each shard (default: 600 s)
#   SLOW_TIME   the programs of the test must keep the watchdog of a drive, so their time passes slower
#               (tests/system/programs/slow_clock.cpp)
#   HEADERS_OF  station or ui: the test shares the headers that tests/CMakeLists.txt precompiles for tests of a whole station
#               or of the window
#   OPTIMISED   for a long test. Other tests are not optimised, because half of a build from nothing compiles tests
function(boresight_add_test name)
  cmake_parse_arguments(T "QT_MAIN;OWN_MAIN;ONE_THREAD;SLOW_TIME;OPTIMISED" "LABEL;TIMEOUT;SHARDS;HEADERS_OF"
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
  get_property(joined GLOBAL PROPERTY BORESIGHT_JOINED_${name})
  add_executable(${name} ${T_SOURCES} ${joined})
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  target_link_libraries(${name} PRIVATE boresight_fakes ${T_LIBRARIES} Qt6::Test ${main} GTest::gmock)
  boresight_unite(${name})
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

# boresight_test_headers(NAME LIBRARIES … HEADERS …)
# Compiles headers once for many test programs. A program that is never run does this, because it has the same options
# as the tests.
function(boresight_test_headers name)
  cmake_parse_arguments(H "" "" "LIBRARIES;HEADERS" ${ARGN})
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "int main()\n{}\n")
  add_executable(${name} EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  set_target_properties(${name} PROPERTIES AUTOMOC OFF)
  target_link_libraries(${name} PRIVATE ${H_LIBRARIES} GTest::gmock)
  target_compile_options(${name} PRIVATE ${test_options})
  boresight_precompile(${name} ${test_headers} ${H_HEADERS})
endfunction()

# Each test has its own settings, so that tests that run at the same time do not disturb each other.
function(boresight_give_home run)
  foreach(kind CONFIG DATA STATE CACHE)
    set_property(TEST ${run} APPEND PROPERTY
      ENVIRONMENT "XDG_${kind}_HOME=${CMAKE_BINARY_DIR}/test-home/${run}/${kind}")
  endforeach()
endfunction()

# For a program with SDL: lsan.supp identifies a leak of SDL by the stack of its allocation. To record these stacks in
# every test takes too long.
function(boresight_note_allocations run)
  if(TEST ${run})
    set_property(TEST ${run} APPEND PROPERTY ENVIRONMENT_MODIFICATION
      "ASAN_OPTIONS=string_append::malloc_context_size=2")
  endif()
endfunction()

# Tests with the label system wait for programs in real time, so the other tests compute at a lower priority.
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
      set_tests_properties(${run} PROPERTIES COST 1500)  # first, because they wait longest
      # AddressSanitizer requires to be loaded first, but works in any order.
      set_property(TEST ${run} APPEND PROPERTY ENVIRONMENT_MODIFICATION
        "LD_PRELOAD=set:$<TARGET_FILE:slow_clock>"
        "ASAN_OPTIONS=string_append::verify_asan_link_order=0")
    endif()
    if(shards GREATER 1 AND NOT slow_time)
      set_tests_properties(${run} PROPERTIES COST 1000)  # early, because otherwise one core runs them at the end
    endif()
  endforeach()
endfunction()
