# Tests of core/points' conversions, mrpt/observations and mrpt/logs.
traverse_test(unit pinhole_test USES sensors)
traverse_test(unit range_row_test USES points)
traverse_test(unit depth_image_test USES points)
traverse_test(unit sweep_test USES points)
traverse_test(unit organise_test USES points)
traverse_test(unit to_scan_test USES observations LIBS ZLIB::ZLIB)
traverse_test(unit external_files_test USES observations)
traverse_test(unit log_wire_test USES logs)
traverse_test(unit byte_source_test USES logs)
# These two look into the room: what the child sends and how bytes end is no public affair.
foreach(inside unit_log_wire_test unit_byte_source_test)
  target_include_directories(${inside} PRIVATE ${PROJECT_SOURCE_DIR}/mrpt_modules/mrpt/logs/src)
endforeach()
