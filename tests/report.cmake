# Tests of report.html: its maps, timelines, the index over runs, and all of it in a browser.
traverse_test(unit layer_map_test USES formats)
traverse_test(unit timeline_test USES formats)
traverse_test(unit run_index_test USES formats)
traverse_test(integration run_index_test LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_run_index_test traverse-map)
traverse_test(integration report_browser_test SLOW USES formats LIBS nlohmann_json::nlohmann_json)
target_sources(integration_report_browser_test PRIVATE support/browser.cpp)
add_dependencies(integration_report_browser_test traverse-map)
