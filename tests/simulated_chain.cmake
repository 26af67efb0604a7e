# From a scene to its scores: traverse-sim, traverse-map, traverse-evaluate.
traverse_test(integration simulated_chain_test USES formats LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_simulated_chain_test traverse-sim traverse-map traverse-evaluate)
traverse_test(unit departures_test USES evaluation)
traverse_test(unit moving_things_test USES simulation)
