# core/ground.
traverse_test(unit ground_test USES ground)
traverse_test(unit relief_test USES ground)
