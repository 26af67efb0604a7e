# The rules of doc/architecture.md, 'Arrows', on the #include lines; link closures are checked by cmake/rooms.cmake.
traverse_test(arrows includes_test)
target_sources(arrows_includes_test PRIVATE support/arrows.cpp)

# MRPT's headers cannot even be found from a core room. The message is looked for, so that a typo in the
# probe does not pass for a refusal; the twin without the forbidden line must compile.
foreach(probe allowed forbidden)
  add_test(NAME arrows_compile_${probe}
    COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -DPROBE_${probe}
      -I${PROJECT_SOURCE_DIR}/mrpt_modules/core/geometry/include -I${PROJECT_SOURCE_DIR}/mrpt_modules/core/options/include
      -I/usr/include/eigen3 ${CMAKE_CURRENT_LIST_DIR}/arrows/probe.cpp)
  set_tests_properties(arrows_compile_${probe} PROPERTIES LABELS "arrows;default")
endforeach()
set_tests_properties(arrows_compile_forbidden PROPERTIES
  PASS_REGULAR_EXPRESSION "mrpt/poses/CPose3D.h: No such file or directory")
