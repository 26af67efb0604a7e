# Simulated sensors: what drives, lidars as packets, poses, recordings.
traverse_test(unit simulated_lidar_test USES simulation)
traverse_test(unit simulated_drive_test USES simulation)
traverse_test(unit recording_test USES simulation)
