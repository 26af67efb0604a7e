# Tests of mrpt/reactive.
traverse_test(integration reactive_drive_test USES reactive)
