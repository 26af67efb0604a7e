# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of how ways are found.
traverse_test(oracle price_field_test USES navigation)
traverse_test(unit planner_test USES navigation)
traverse_test(unit plan_near_test USES navigation)
traverse_test(unit replan_test USES navigation)
traverse_test(property grid_plan_test USES navigation)
traverse_test(unit hybrid_plan_test USES navigation)
traverse_test(property hybrid_plan_property_test USES navigation)
traverse_test(unit track_path_test USES navigation simulation)
traverse_test(unit lead_in_test USES navigation)
