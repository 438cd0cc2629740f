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

# Generates C types with Cyclone's IDL compiler from every IDL file that stetro_msgs ships.
#   CYCLONE_TYPES_DIR      where the headers are
#   CYCLONE_TYPES_SOURCES  the generated C files

find_program(IDLC idlc REQUIRED)
set(CYCLONE_TYPES_DIR ${CMAKE_CURRENT_BINARY_DIR}/cyclone_types)
set(mangled_dir ${CMAKE_CURRENT_BINARY_DIR}/mangled_idl)
set(shipped_dir ${stetro_msgs_DIR}/../idl)
file(GLOB shipped_idl CONFIGURE_DEPENDS ${shipped_dir}/ros2/*.idl ${shipped_dir}/stetro_msgs/*.idl)
file(MAKE_DIRECTORY ${CYCLONE_TYPES_DIR})

set(CYCLONE_TYPES_SOURCES)
set(cyclone_types_headers)
set(compile_idl)
foreach(idl IN LISTS shipped_idl)
  get_filename_component(type ${idl} NAME_WE)
  list(APPEND CYCLONE_TYPES_SOURCES ${CYCLONE_TYPES_DIR}/${type}.c)
  list(APPEND cyclone_types_headers ${CYCLONE_TYPES_DIR}/${type}.h)
  list(APPEND compile_idl COMMAND ${IDLC} -t -f case-sensitive
    -I ${mangled_dir} -o ${CYCLONE_TYPES_DIR} ${mangled_dir}/${type}.idl)
endforeach()

set(mangle_idl ${CMAKE_CURRENT_SOURCE_DIR}/cyclone/mangle_idl.py)
add_custom_command(
  OUTPUT ${CYCLONE_TYPES_SOURCES} ${cyclone_types_headers}
  COMMAND ${Python3_EXECUTABLE} ${mangle_idl} ${mangled_dir} ${shipped_idl}
  ${compile_idl}
  DEPENDS ${shipped_idl} ${mangle_idl}
  COMMENT "Generating Cyclone DDS types"
  VERBATIM)
