# Drives without end: memory and time per cloud stay as they are.
traverse_test(unit driven_cells_test USES traversability_grid)
traverse_test(property traversability_endless_slow_test USES traversability_grid SLOW)
