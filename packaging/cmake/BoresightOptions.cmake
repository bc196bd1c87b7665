# SPDX-License-Identifier: GPL-3.0-or-later
# The options of every target of Boresight: C++20, warnings as errors, the sanitizers of the preset.

set(BORESIGHT_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined or thread")

add_library(boresight_options INTERFACE)
# Programs are compiled like libraries, so that they share precompiled headers.
target_compile_options(boresight_options INTERFACE -fPIC)
target_compile_features(boresight_options INTERFACE cxx_std_20)
target_compile_options(boresight_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Werror
  -Wno-missing-field-initializers)  # designated initialisers leave the rest at its default on purpose
target_compile_definitions(boresight_options INTERFACE
  BORESIGHT_VERSION="${PROJECT_VERSION}"
  QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_FOREACH QT_NO_KEYWORDS QT_DISABLE_DEPRECATED_BEFORE=0x060400)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 at -O2 does not notice that a union was moved from (tl::expected), and destroys its string twice.
  target_compile_options(boresight_options INTERFACE -fno-ipa-modref)
else()
  # Warnings that GCC does not have under these names.
  target_compile_options(boresight_options INTERFACE -Wno-sign-conversion)
endif()
target_include_directories(boresight_options INTERFACE "${CMAKE_SOURCE_DIR}")
if(BORESIGHT_SANITIZE)
  # AddressSanitizer checks every use of a pointer. These additional checks take a third of the compiler's time. The
  # check of alignment takes 10 to 20 % more. It is not needed, because pointers are only cast to sockaddr and to bytes.
  target_compile_options(boresight_options INTERFACE
    -fsanitize=${BORESIGHT_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    -fno-sanitize=null,object-size,vptr,pointer-overflow,alignment)
  if(BORESIGHT_SANITIZE MATCHES "address" AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # The search for uses of a local variable after the return of its function costs a third of the time of all tests.
    # The compiler warns of most of them.
    target_compile_options(boresight_options INTERFACE -fsanitize-address-use-after-return=never)
  endif()
  target_compile_definitions(boresight_options INTERFACE BORESIGHT_SANITIZED)
  target_link_options(boresight_options INTERFACE -fsanitize=${BORESIGHT_SANITIZE})
  if(BORESIGHT_SANITIZE MATCHES "thread")
    target_compile_definitions(boresight_options INTERFACE BORESIGHT_THREAD_SANITIZED)
    # Qt's own library is not instrumented. This object informs ThreadSanitizer about the order that Qt's event queue
    # ensures.
    add_library(boresight_qt_event_order OBJECT "${CMAKE_SOURCE_DIR}/tests/sanitizers/qt_event_order.cpp")
    target_compile_features(boresight_qt_event_order PRIVATE cxx_std_20)
    target_compile_options(boresight_qt_event_order PRIVATE -fsanitize=${BORESIGHT_SANITIZE})
    target_link_libraries(boresight_qt_event_order PRIVATE Qt6::Core)
    target_link_libraries(boresight_options INTERFACE $<TARGET_OBJECTS:boresight_qt_event_order>)
    # Its operator new replaces the one of clang. This is not possible if that one is linked statically.
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-runtime-dir
      OUTPUT_VARIABLE runtimes OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    target_link_options(boresight_options INTERFACE -shared-libsan "-Wl,-rpath,${runtimes}")
    target_link_options(boresight_options INTERFACE
      -Wl,--wrap=_ZN7QThread4waitE14QDeadlineTimer -Wl,--wrap=_ZN11QThreadPool5startESt8functionIFvvEEi
      -Wl,--wrap=_ZN11QThreadPoolD1Ev
      -Wl,--wrap=_ZN11QMetaObject16invokeMethodImplEP7QObjectPN9QtPrivate15QSlotObjectBaseEN2Qt14ConnectionTypeEPv)
  endif()
endif()

# More than 100 programs are linked. mold takes a tenth of the time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold BORESIGHT_HAS_MOLD)
if(BORESIGHT_HAS_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_AUTOMOC ON)
set(CMAKE_AUTORCC ON)

# A precompiled header is compared by its definitions, not by its date.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    "${CMAKE_COMMAND};-E;env;CCACHE_BASEDIR=${CMAKE_SOURCE_DIR};CCACHE_NOHASHDIR=1"
    "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime;${CCACHE_PROGRAM}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(boresight_options INTERFACE -fpch-preprocess)
  else()
    target_compile_options(boresight_options INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()

# boresight_precompile(TARGET HEADER…)
# Compiles headers that nearly every source of a target includes once. This saves half of the time of a build from
# nothing.
function(boresight_precompile target)
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

# boresight_moc_alone(TARGET): moc_alone.sh.in reads the classes of the target that have Q_OBJECT.
function(boresight_moc_alone target)
  get_target_property(BORESIGHT_MOC Qt6::moc IMPORTED_LOCATION)
  configure_file("${CMAKE_SOURCE_DIR}/packaging/cmake/moc_alone.sh.in" "${CMAKE_BINARY_DIR}/moc_alone.sh" @ONLY
    USE_SOURCE_PERMISSIONS)
  set_target_properties(${target} PROPERTIES AUTOMOC_EXECUTABLE "${CMAKE_BINARY_DIR}/moc_alone.sh")
endfunction()

option(BORESIGHT_UNITY "Compile several sources of a folder at once: half of the time of a build from nothing" ON)

# boresight_unite(TARGET)
# Call it after all sources were added. It compiles the sources of a folder at once, together with those of the next
# folders while they are few. Most of a compiler's time goes into headers, which such a group reads once. A name in an
# anonymous namespace must be unique in its group. Each source includes all headers that it needs, because the preset
# dev compiles each source alone.
function(boresight_unite target)
  if(NOT BORESIGHT_UNITY)
    return()
  endif()
  set(most 32)  # sources of a group
  get_target_property(sources ${target} SOURCES)
  get_target_property(home ${target} SOURCE_DIR)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  set(folders "")
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${home}" NORMALIZE OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    list(APPEND "in_${folder}" "${path}")
    list(APPEND folders "${folder}")
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(group 0)
  set(size 0)
  foreach(folder IN LISTS folders)
    list(LENGTH "in_${folder}" count)
    math(EXPR together "${size} + ${count}")
    if(size GREATER 0 AND together GREATER most)
      math(EXPR group "${group} + 1")
      set(size 0)
    endif()
    math(EXPR size "${size} + ${count}")
    set_source_files_properties(${in_${folder}} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC sees a type of an anonymous namespace in an included file, and does not know that the file is included only
    # once.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
