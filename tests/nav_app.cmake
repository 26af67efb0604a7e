# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# traverse-nav: the closed loop.
# newcomer_test checks its inis, too
add_dependencies(integration_newcomer_test traverse-nav)
traverse_test(integration traverse_nav_test USES nav_app)
traverse_test(integration traverse_nav_replay_test USES nav_app)
