# Tests of mrpt/config.
traverse_test(unit ini_document_test USES config geometry)
