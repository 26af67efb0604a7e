# traverse-map as a user runs it; the binary is a dependency, not a library.
foreach(name traverse_map_test traverse_map_errors_test newcomer_test)
  traverse_test(integration ${name} LIBS nlohmann_json::nlohmann_json)
  add_dependencies(integration_${name} traverse-map)
endforeach()

traverse_test(integration grabber_capture_test SLOW SERIAL LIBS nlohmann_json::nlohmann_json mrpt::obs mrpt::maps)
add_dependencies(integration_grabber_capture_test traverse-map)
