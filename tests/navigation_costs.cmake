# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of drive/navigation: costs, obstacles, speeds, watchdogs.
traverse_test(unit costmap_test USES navigation)
traverse_test(unit costmap_maps_test USES navigation)
traverse_test(unit explain_cost_test USES navigation)
traverse_test(unit obstacle_points_test USES navigation)
traverse_test(unit motion_guard_test USES navigation)
traverse_test(unit speed_profile_test USES navigation)
traverse_test(unit grip_test USES navigation)
traverse_test(unit supervisor_test USES navigation)
traverse_test(unit supervisor_recovery_test USES navigation)
traverse_test(property grip_drive_test USES navigation simulation)
traverse_test(property costmap_property_test USES navigation)
