# Tests of core/formats and mrpt/rendering.
traverse_test(unit archive_test USES formats)
traverse_test(property archive_fuzz_test USES formats)
