# Tests of worlds/evaluation and traverse-evaluate.
traverse_test(unit confusion_test USES evaluation)
