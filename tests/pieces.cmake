# The same bytes whatever the processor, the threads and the pieces.
traverse_test(unit exact_trig_test USES geometry)
traverse_test(property traversability_merge_test USES traversability_grid)
traverse_test(integration log_pieces_test USES logs)
