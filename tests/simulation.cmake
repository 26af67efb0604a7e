# What simulated worlds are made of: random numbers, motions, rays. Scenes, sensors and truth have lists of their own.
traverse_test(unit ray_caster_test USES simulation)
traverse_test(unit random_test USES simulation)
