# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
find_dependency(mrpt-maps)
find_dependency(mrpt-opengl)
include(${CMAKE_CURRENT_LIST_DIR}/traverseTargets.cmake)
