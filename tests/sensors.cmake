# Tests of core/sensors, of core/points' Velodyne conversion, and of the pcap reader.
traverse_test(oracle velodyne_cloud_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(oracle nebula_cloud_test USES points formats LIBS ZLIB::ZLIB)
traverse_test(oracle velodyne_mrpt_test USES points formats LIBS mrpt::obs ZLIB::ZLIB)
