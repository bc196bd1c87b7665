# SPDX-License-Identifier: GPL-3.0-or-later

# boresight_floor(NAME ROOMS folder… LINKS library… [INSIDE library…] [HEADERS header… | HEADERS_OF floor])
# The library boresight_NAME of a floor of the house. A room adds its sources by target_sources(${floor} …).
#   LINKS       the floors below, and other libraries that the headers of this floor use
#   INSIDE      libraries that only the sources of this floor use
#   HEADERS     headers that are compiled once for all sources of the floor
#   HEADERS_OF  the floor whose compiled headers are used
# The program floor_NAME links a floor only with the floors below it. It is never run. A source that uses a higher floor does
# not link there. tests/rooms_test.cpp finds a wrong include within a floor.
function(boresight_floor name)
  cmake_parse_arguments(F "" "HEADERS_OF" "ROOMS;LINKS;INSIDE;HEADERS" ${ARGN})
  set(floor boresight_${name})
  add_library(${floor} STATIC)
  target_link_libraries(${floor} PUBLIC ${F_LINKS} PRIVATE ${F_INSIDE})
  foreach(room IN LISTS F_ROOMS)
    add_subdirectory(${room})
  endforeach()
  if(F_HEADERS)
    boresight_precompile(${floor} ${F_HEADERS})
  else()
    target_precompile_headers(${floor} REUSE_FROM boresight_${F_HEADERS_OF})
  endif()
  boresight_moc_alone(${floor})
  boresight_unite(${floor})
  if(BUILD_TESTING AND NOT BORESIGHT_SANITIZE)
    file(CONFIGURE OUTPUT floor_${name}.cpp CONTENT "int main()\n{}\n")
    add_executable(floor_${name} "${CMAKE_CURRENT_BINARY_DIR}/floor_${name}.cpp")
    set_target_properties(floor_${name} PROPERTIES AUTOMOC OFF AUTORCC OFF
      RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/floors")
    target_link_libraries(floor_${name} PRIVATE "$<LINK_LIBRARY:WHOLE_ARCHIVE,${floor}>")
  endif()
endfunction()
