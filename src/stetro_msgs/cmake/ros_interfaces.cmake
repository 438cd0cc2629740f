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

# On a machine with ROS 2 the package is an interface package too: `ros2 topic echo`, bags and RViz
# need the definitions. Elsewhere the .msg files are installed where a ROS 2 tool looks for them.

find_package(rosidl_default_generators QUIET)
if(rosidl_default_generators_FOUND)
  find_package(builtin_interfaces REQUIRED)
  find_package(geometry_msgs REQUIRED)
  find_package(std_msgs REQUIRED)
  file(GLOB interfaces CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} msg/*.msg)
  rosidl_generate_interfaces(${PROJECT_NAME} ${interfaces}
    DEPENDENCIES builtin_interfaces geometry_msgs std_msgs)
  ament_export_dependencies(rosidl_default_runtime)
else()
  install(DIRECTORY msg DESTINATION share/${PROJECT_NAME})
endif()
