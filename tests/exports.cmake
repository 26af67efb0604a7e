# Tests of the formats that others read: GeoPackage, PLY, PCD.
traverse_test(integration exports_test USES formats LIBS mrpt::maps)
traverse_test(integration pcl_tools_test SLOW USES formats)
