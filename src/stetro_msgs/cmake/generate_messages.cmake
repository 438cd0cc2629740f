# Copyright 2026 The sTetro Authors
#
# Licensed under the Apache License, Version 2.0 (the "License");
# you may not use this file except in compliance with the License.
# You may obtain a copy of the License at
#
#     http://www.apache.org/licenses/LICENSE-2.0
#
# Unless required by applicable law or agreed to in writing, software
# distributed under the License is distributed on an "AS IS" BASIS,
# WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
# See the License for the specific language governing permissions and
# limitations under the License.

# Generates, at build time, C++ from every IDL file below idl/ with one start of fastddsgen.
#
# The output is flat and an included type is generated again by whoever includes it, so one call
# for all files is both the fast way and the only one without two writers of one file. Sets
#   STETRO_MSGS_IDL      the IDL files
#   STETRO_MSGS_SOURCES  the generated .cxx files
#   STETRO_MSGS_HEADERS  the generated headers, all below generated/stetro_msgs/

file(GLOB STETRO_MSGS_IDL CONFIGURE_DEPENDS
  ${CMAKE_CURRENT_SOURCE_DIR}/idl/ros2/*.idl ${CMAKE_CURRENT_SOURCE_DIR}/idl/stetro_msgs/*.idl)
find_program(FASTDDSGEN fastddsgen REQUIRED)

set(generated_dir ${CMAKE_CURRENT_BINARY_DIR}/generated/stetro_msgs)
set(scratch_dir ${CMAKE_CURRENT_BINARY_DIR}/fastddsgen)
file(MAKE_DIRECTORY ${generated_dir} ${scratch_dir})

set(STETRO_MSGS_SOURCES)
set(fastddsgen_headers)
set(own_headers ${generated_dir}/all_messages.hpp)
foreach(idl IN LISTS STETRO_MSGS_IDL)
  get_filename_component(type ${idl} NAME_WE)
  list(APPEND STETRO_MSGS_SOURCES
    ${generated_dir}/${type}.cxx ${generated_dir}/${type}PubSubTypes.cxx)
  list(APPEND fastddsgen_headers
    ${generated_dir}/${type}.h ${generated_dir}/${type}PubSubTypes.h)
  list(APPEND own_headers ${generated_dir}/${type}.hpp)
endforeach()
set(STETRO_MSGS_HEADERS ${fastddsgen_headers} ${own_headers})

add_custom_command(
  OUTPUT ${STETRO_MSGS_SOURCES} ${fastddsgen_headers}
  COMMAND ${FASTDDSGEN} -typeros2 -cs -replace
    -I ${CMAKE_CURRENT_SOURCE_DIR}/idl/ros2 -I ${CMAKE_CURRENT_SOURCE_DIR}/idl/stetro_msgs
    -t ${scratch_dir} -d ${generated_dir} ${STETRO_MSGS_IDL} > ${scratch_dir}/log
  DEPENDS ${STETRO_MSGS_IDL}
  COMMENT "Generating the messages with fastddsgen"
  VERBATIM)

set(headers_from_idl ${CMAKE_CURRENT_SOURCE_DIR}/cmake/headers_from_idl.py)
add_custom_command(
  OUTPUT ${own_headers}
  COMMAND ${Python3_EXECUTABLE} ${headers_from_idl} ${generated_dir} ${STETRO_MSGS_IDL}
  DEPENDS ${STETRO_MSGS_IDL} ${headers_from_idl}
  COMMENT "Listing the members of the messages"
  VERBATIM)
