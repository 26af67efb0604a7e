# Tests of core/options, geometry, poses and points.
traverse_test(unit options_test USES geometry)
traverse_test(unit geometry_test USES geometry)
traverse_test(unit outline_test USES geometry)
traverse_test(unit pose_track_test USES poses)
traverse_test(unit timing_test USES poses)
traverse_test(unit deskew_test USES points)
