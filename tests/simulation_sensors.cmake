# Simulated sensors: what drives, lidars as packets, poses, recordings.
traverse_test(unit simulated_lidar_test USES simulation)
traverse_test(unit simulated_drive_test USES simulation)
traverse_test(unit recording_test USES simulation)
traverse_test(unit simulated_motion_test USES simulation)
traverse_test(oracle simulated_lidar_figures_test USES simulation formats LIBS ZLIB::ZLIB)
traverse_test(integration traverse_sim_test USES logs formats)
add_dependencies(integration_traverse_sim_test traverse-sim)
