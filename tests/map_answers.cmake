# Tests of the explanation of a cell: maps/traversability_grid, traverse-map --why.
traverse_test(unit traversability_explain_test USES traversability_grid)
traverse_test(integration why_test LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_why_test traverse-map)
traverse_test(integration point_labels_test USES observations LIBS nlohmann_json::nlohmann_json mrpt::maps mrpt::obs ZLIB::ZLIB)
add_dependencies(integration_point_labels_test traverse-map)
