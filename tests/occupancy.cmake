# Tests of how occupancy is judged.
traverse_test(unit occupancy_score_test USES evaluation)
traverse_test(property random_streets_test USES simulating)
