# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Every library comes from Debian 12; `run` installs the packages.
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(CLI11 2.1 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(GDAL 3.6 REQUIRED)
find_package(octomap 1.9 REQUIRED)
foreach(module core config io img math poses obs opengl maps slam serialization rtti system)
  find_package(mrpt-${module} 2.5 REQUIRED)
endforeach()
