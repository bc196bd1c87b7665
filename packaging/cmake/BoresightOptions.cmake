# SPDX-License-Identifier: GPL-3.0-or-later
# What every target of ours is compiled with: C++20, warnings as errors, the sanitizers of the preset.

set(BORESIGHT_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

add_library(boresight_options INTERFACE)
target_compile_features(boresight_options INTERFACE cxx_std_20)
target_compile_options(boresight_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Werror
  -Wno-missing-field-initializers)  # designated initialisers leave the rest at its default on purpose
target_compile_definitions(boresight_options INTERFACE
  BORESIGHT_VERSION="${PROJECT_VERSION}"
  QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_FOREACH QT_NO_KEYWORDS QT_DISABLE_DEPRECATED_BEFORE=0x060400)
target_include_directories(boresight_options INTERFACE "${CMAKE_SOURCE_DIR}")
if(BORESIGHT_SANITIZE)
  target_compile_options(boresight_options INTERFACE
    -fsanitize=${BORESIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(boresight_options INTERFACE -fsanitize=${BORESIGHT_SANITIZE})
  if(BORESIGHT_SANITIZE MATCHES "thread")
    # GCC 12 says atomic_thread_fence is unsupported under TSan inside Qt's own headers.
    target_compile_options(boresight_options INTERFACE -Wno-error=tsan)
    # Qt's own library is not instrumented: this object tells ThreadSanitizer what Qt's event queue orders.
    add_library(boresight_qt_event_order OBJECT "${CMAKE_SOURCE_DIR}/tests/sanitizers/qt_event_order.cpp")
    target_compile_features(boresight_qt_event_order PRIVATE cxx_std_20)
    target_compile_options(boresight_qt_event_order PRIVATE -fsanitize=${BORESIGHT_SANITIZE})
    target_link_libraries(boresight_qt_event_order PRIVATE Qt6::Core)
    target_link_libraries(boresight_options INTERFACE $<TARGET_OBJECTS:boresight_qt_event_order>)
    target_link_options(boresight_options INTERFACE -Wl,--wrap=_ZN7QThread4waitE14QDeadlineTimer)
  endif()
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_AUTOMOC ON)
set(CMAKE_AUTORCC ON)

# One cache for every checkout: paths below the source folder are made relative before hashing, and a precompiled header
# is compared by what it defines rather than by its date.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND};-E;env;CCACHE_BASEDIR=${CMAKE_SOURCE_DIR};CCACHE_NOHASHDIR=1"
    "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;${CCACHE_PROGRAM}")
  target_compile_options(boresight_options INTERFACE -fpch-preprocess)
endif()

# boresight_precompile(TARGET HEADER…)
# Headers that nearly every source of a target includes are compiled once for it: half of the time of a build from
# nothing.
function(boresight_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()
