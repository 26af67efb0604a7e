# core/ground.
traverse_test(unit ground_test USES ground)
