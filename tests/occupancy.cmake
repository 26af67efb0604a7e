# Tests of how occupancy is judged.
traverse_test(unit occupancy_score_test USES evaluation)
traverse_test(property random_streets_test USES simulating)
traverse_test(integration overhang_table_test USES simulating evaluation multi_lidar_grid LIBS nlohmann_json::nlohmann_json)
traverse_test(integration states_chain_test USES formats LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_states_chain_test traverse-sim traverse-map traverse-evaluate)
