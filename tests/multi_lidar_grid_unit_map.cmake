# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# maps/multi_lidar_grid: a cloud's unit map.
traverse_test(unit unit_map_test USES multi_lidar_grid)
traverse_test(unit unit_map_ditches_test USES multi_lidar_grid)
traverse_test(unit unit_map_overhangs_test USES multi_lidar_grid)
traverse_test(unit sensor_path_test USES multi_lidar_grid)
traverse_test(oracle unit_map_paper_test USES multi_lidar_grid)
