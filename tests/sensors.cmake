# Tests of core/sensors, of core/points' Velodyne conversion, and of the pcap reader.
traverse_test(oracle velodyne_cloud_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(oracle nebula_cloud_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(oracle velodyne_mrpt_test USES points formats LIBS mrpt::obs ZLIB::ZLIB)
traverse_test(unit velodyne_packet_test USES sensors)
traverse_test(unit velodyne_scan_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(property velodyne_property_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(unit pcap_test USES formats LIBS ZLIB::ZLIB)
traverse_test(integration velodyne_captures_test USES points formats LIBS ZLIB::ZLIB)
