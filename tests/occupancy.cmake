# Tests of how occupancy is judged.
traverse_test(unit occupancy_score_test USES evaluation)
traverse_test(property random_streets_test USES simulating)
traverse_test(integration overhang_table_test USES simulating evaluation multi_lidar_grid LIBS nlohmann_json::nlohmann_json)
