# Tests of worlds/evaluation and traverse-evaluate.
traverse_test(unit confusion_test USES evaluation)
traverse_test(unit obstacle_scores_test USES evaluation)
traverse_test(unit trajectory_errors_test USES evaluation)
traverse_test(unit verdicts_test USES evaluation)
traverse_test(unit report_addition_test USES formats)
traverse_test(integration traverse_evaluate_test USES formats LIBS nlohmann_json::nlohmann_json)
add_dependencies(integration_traverse_evaluate_test traverse-map traverse-evaluate)
