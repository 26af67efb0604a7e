# SPDX-FileCopyrightText: 2026 the Traverse authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of mrpt/ros_bags. ROS's own message headers and bag writer make what is read.
traverse_test(unit bag_messages_test USES ros_bags LIBS rosbag::storage)
traverse_test(unit bag_order_test USES ros_bags LIBS rosbag::storage)
traverse_test(property bag_messages_fuzz_test USES ros_bags LIBS rosbag::storage)
# They look into the room: bytes of messages are no public affair.
foreach(inside unit_bag_messages_test unit_bag_order_test property_bag_messages_fuzz_test)
  target_include_directories(${inside} PRIVATE ${PROJECT_SOURCE_DIR}/mrpt_modules/mrpt/ros_bags/src)
endforeach()
traverse_test(integration ros_bag_test USES ros_bags LIBS rosbag::storage)
traverse_test(integration ros_bag_log_test USES ros_bags LIBS rosbag::storage)
traverse_test(integration ros_bag_images_test USES ros_bags LIBS rosbag::storage)
traverse_test(integration ros_bag_damage_test USES ros_bags LIBS rosbag::storage)
traverse_test(integration ros_bag_damage_slow_test USES ros_bags LIBS rosbag::storage SLOW)
