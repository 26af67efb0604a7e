# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of traverse-inspect.
foreach(test inspect_log_test inspect_maps_test inspect_doctor_test)
  traverse_test(integration ${test} USES observations LIBS nlohmann_json::nlohmann_json mrpt::maps mrpt::obs ZLIB::ZLIB)
  add_dependencies(integration_${test} traverse-inspect)
endforeach()
add_dependencies(integration_inspect_maps_test traverse-map)
