# Cells that wrap round, distances between cells, and the safety buffer.
traverse_test(unit torus_test USES geometry)
traverse_test(property wrapped_grid_test USES layers)
traverse_test(oracle distance_transform_test USES layers)
traverse_test(unit safety_buffer_test USES layers)
traverse_test(property safety_strip_test USES layers)
traverse_test(integration safety_buffer_pictures_test USES layers formats)
