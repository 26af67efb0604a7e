# Tests of core/registration, core/poses' ins, and of both as pose sources.
traverse_test(unit scan_to_map_test USES registration)
traverse_test(unit odometry_to_map_test USES registration)
traverse_test(unit ins_test USES poses)
traverse_test(integration pose_sources_test USES logs LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_pose_sources_test traverse-map)
