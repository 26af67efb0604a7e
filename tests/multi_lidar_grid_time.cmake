# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
traverse_test(unit lidar_accumulate_test USES multi_lidar_grid)
traverse_test(unit lidar_sensors_test USES multi_lidar_grid)
traverse_test(unit clock_offset_test USES multi_lidar_grid simulation)
traverse_test(property multi_lidar_endless_slow_test USES multi_lidar_grid SLOW)
