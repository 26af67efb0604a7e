# The same bytes whatever the processor, the threads and the pieces.
traverse_test(unit exact_trig_test USES geometry)
