# Tests of the scenes of worlds/simulation and of their files.
traverse_test(unit simulation_terrain_test USES simulation)
traverse_test(unit simulation_objects_test USES simulation)
traverse_test(unit scene_file_test USES simulating)
traverse_test(property random_scenes_test USES simulating)
