# Tests of what the map of several lidars shows, keeps and says of itself, and of all maps' shells.
traverse_test(unit multi_lidar_layers_test USES multi_lidar_grid)
traverse_test(unit multi_lidar_answers_test USES multi_lidar_grid)
traverse_test(property multi_lidar_archive_test USES multi_lidar_grid)
traverse_test(integration every_map_test
  USES plugin traversability_grid multi_lidar_grid config observations formats
  LIBS mrpt::maps mrpt::obs)
traverse_test(integration multi_lidar_map_test
  USES plugin traversability_grid multi_lidar_grid config observations formats
  LIBS mrpt::maps mrpt::obs)
traverse_test(integration multi_lidar_run_test LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_multi_lidar_run_test traverse-map)
