# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Every library comes from Debian 12; `run` installs the packages.
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(GIF 5 REQUIRED)
find_package(GDAL 3.6 REQUIRED)
find_package(octomap 1.9 REQUIRED)
# ROS 1's bag reader. Its own CMake and pkg-config files of Debian 12 want packages that nobody needs
# to read a bag (ament, a pluginlib.pc that is not there), so it is found by its files.
find_package(Boost REQUIRED)
add_library(rosbag::storage INTERFACE IMPORTED)
foreach(header rosbag/bag.h pluginlib/class_loader.hpp class_loader/class_loader.hpp
    ament_index_cpp/get_resource.hpp rcutils/logging.h rcpputils/shared_library.hpp)
  get_filename_component(package ${header} DIRECTORY)
  find_path(ROSBAG_INCLUDE_${package} ${header} PATH_SUFFIXES ${package} REQUIRED)
  target_include_directories(rosbag::storage INTERFACE ${ROSBAG_INCLUDE_${package}})
endforeach()
foreach(name rosbag_storage roscpp_serialization rostime cpp_common console_bridge)
  find_library(ROSBAG_${name} ${name} REQUIRED)
  target_link_libraries(rosbag::storage INTERFACE ${ROSBAG_${name}})
endforeach()
foreach(module core config io img math poses obs opengl maps slam nav serialization rtti system)
  find_package(mrpt-${module} 2.5 REQUIRED)
endforeach()
find_package(embree 3.13 REQUIRED)
find_package(ompl 1.5 REQUIRED)  # Reeds-Shepp curves; its CMake file of Debian 12 names no target
if(NOT TARGET ompl::ompl)
  add_library(ompl::ompl INTERFACE IMPORTED)
  find_library(OMPL_LIBRARY ompl PATHS ${OMPL_LIBRARY_DIRS} REQUIRED)
  target_include_directories(ompl::ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIR})
  target_link_libraries(ompl::ompl INTERFACE ${OMPL_LIBRARY})
endif()
