# Truth of simulated scenes.
traverse_test(unit cell_truth_test USES simulation)
traverse_test(unit footprints_test USES simulation)
traverse_test(integration geotiff_read_test USES simulation)
traverse_test(oracle cell_truth_test USES simulation)
