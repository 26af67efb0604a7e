# Vehicles that drive in simulated worlds, what they touch there, and the worlds made for navigators.
traverse_test(unit vehicle_model_test USES simulation)
traverse_test(unit surroundings_test USES simulation)
traverse_test(property mission_worlds_test USES simulating)
