# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of core/diagnosis.
traverse_test(unit diagnosis_test USES diagnosis)
traverse_test(unit crispness_test USES diagnosis)
