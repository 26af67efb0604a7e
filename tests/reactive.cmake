# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of mrpt/reactive.
traverse_test(unit reactive_inside_test USES reactive)
target_include_directories(unit_reactive_inside_test PRIVATE ${PROJECT_SOURCE_DIR}/mrpt_modules/mrpt/reactive/src)
traverse_test(integration reactive_drive_test USES reactive)
traverse_test(integration reactive_driver_test USES reactive LIBS mrpt::io)
traverse_test(integration reactive_faults_test USES reactive)
