# Tests of the octree beside a map: core/formats, the shell, traverse-map --rebuild.
traverse_test(unit point_octree_test USES formats)
traverse_test(property octree_fuzz_test USES formats)
traverse_test(integration octomap_tools_test USES formats)
traverse_test(integration octree_map_test USES plugin traversability_grid config observations formats
  LIBS mrpt::maps mrpt::obs)
traverse_test(integration rebuild_test USES traversability_grid LIBS fmt::fmt nlohmann_json::nlohmann_json)
foreach(name octomap_tools_test rebuild_test)
endforeach()
add_dependencies(integration_rebuild_test traverse-map)
