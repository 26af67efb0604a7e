# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of side files, cloud files, mrpt/importing and traverse-import.
traverse_test(unit point_channels_test USES formats)
traverse_test(unit cloud_file_test USES formats)
traverse_test(integration log_channels_test USES logs)
# traverse-import as a user runs it.
traverse_test(integration traverse_import_test USES logs LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_traverse_import_test traverse-import traverse-map)
traverse_test(integration traverse_import_errors_test USES logs importing)
add_dependencies(integration_traverse_import_errors_test traverse-import)
traverse_test(integration import_bag_test USES logs ros_bags LIBS rosbag::storage)
add_dependencies(integration_import_bag_test traverse-import)
