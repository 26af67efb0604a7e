# Tests of core/points' conversions, mrpt/observations and mrpt/logs.
traverse_test(unit pinhole_test USES sensors)
traverse_test(unit range_row_test USES points)
traverse_test(unit depth_image_test USES points)
traverse_test(unit sweep_test USES points)
traverse_test(unit organise_test USES points)
