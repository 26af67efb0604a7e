# Tests of core/layers' storage and of maps/traversability_grid.
traverse_test(unit tile_grid_test USES layers)
traverse_test(unit height_slabs_test USES layers)
traverse_test(unit lattice_points_test USES traversability_grid)
traverse_test(unit scan_cells_test USES traversability_grid)
traverse_test(unit traversability_features_test USES traversability_grid)
traverse_test(unit traversability_scenes_test USES traversability_grid)
traverse_test(unit traversability_default_test USES traversability_grid)
traverse_test(unit traversability_forgetting_test USES traversability_grid)
traverse_test(property traversability_order_test USES traversability_grid)
traverse_test(property traversability_archive_test USES traversability_grid)
traverse_test(oracle traversability_kitti_test USES traversability_grid LIBS ZLIB::ZLIB)
traverse_test(oracle ground_labels_test USES traversability_grid LIBS ZLIB::ZLIB)
traverse_test(integration traversability_map_test
  USES plugin traversability_grid config observations formats LIBS mrpt::maps mrpt::obs)
traverse_test(integration traversability_likelihood_test
  USES plugin traversability_grid observations LIBS mrpt::maps mrpt::obs)
traverse_test(integration stock_programs_test USES traversability_grid multi_lidar_grid)
add_dependencies(integration_stock_programs_test traverse_plugin)

# An outside project finds, links and runs the installed package.
add_test(NAME install_outside_project COMMAND ${CMAKE_COMMAND}
  -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR} -DWORK=${PROJECT_BINARY_DIR}/install_test
  -P ${CMAKE_CURRENT_LIST_DIR}/install/outside_test.cmake)
set_tests_properties(install_outside_project PROPERTIES LABELS "install;default" TIMEOUT 600)
traverse_test(integration stock_viewers_test USES plugin layers traversability_grid multi_lidar_grid observations
  LIBS mrpt::maps mrpt::obs mrpt::opengl SLOW SERIAL)
