# Tests of worlds/evaluation and traverse-evaluate.
traverse_test(unit confusion_test USES evaluation)
traverse_test(unit obstacle_scores_test USES evaluation)
traverse_test(unit trajectory_errors_test USES evaluation)
