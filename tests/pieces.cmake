# The same bytes whatever the processor, the threads and the pieces.
traverse_test(unit exact_trig_test USES geometry)
traverse_test(property traversability_merge_test USES traversability_grid)
traverse_test(integration log_pieces_test USES logs)
foreach(name traverse_map_pieces_test traverse_map_merge_errors_test other_processor_test)
  traverse_test(integration ${name} USES observations formats
    LIBS nlohmann_json::nlohmann_json mrpt::obs mrpt::maps ZLIB::ZLIB)
  add_dependencies(integration_${name} traverse-map)
endforeach()
