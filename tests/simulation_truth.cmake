# Truth of simulated scenes.
traverse_test(unit cell_truth_test USES simulation)
