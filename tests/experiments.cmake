# Accuracy experiments: `./run experiment NAME`. One program each; the last line of its stdout is one JSON object.
add_custom_target(experiments)
foreach(name velodyne_returns)
  add_executable(experiment_${name} EXCLUDE_FROM_ALL experiments/${name}.cpp)
  target_link_libraries(experiment_${name} PRIVATE traverse::observations nlohmann_json::nlohmann_json mrpt::maps)
  add_dependencies(experiments experiment_${name})
endforeach()
