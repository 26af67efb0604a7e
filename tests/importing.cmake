# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of side files, cloud files, mrpt/importing and traverse-import.
traverse_test(unit point_channels_test USES formats)
traverse_test(unit cloud_file_test USES formats)
traverse_test(integration log_channels_test USES logs)
