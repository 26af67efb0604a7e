# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# traverse-nav: the closed loop.
traverse_test(integration traverse_nav_test USES nav_app)
