# Tests of core/formats and mrpt/rendering.
traverse_test(unit archive_test USES formats)
traverse_test(property archive_fuzz_test USES formats)
traverse_test(unit safe_file_test USES formats)
traverse_test(unit output_folder_test USES formats)
traverse_test(integration output_faults_test USES formats)
