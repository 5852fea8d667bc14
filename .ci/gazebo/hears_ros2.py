"""A ROS 2 node that hears one torque a joint and prints them as JSON: hears_ros2.py N"""

from __future__ import annotations

import json
import sys
import time

import rclpy
from std_msgs.msg import Float64MultiArray

rclpy.init()
node = rclpy.create_node("ear")
heard: dict[int, float] = {}
n = int(sys.argv[1])
for i in range(1, n + 1):
    node.create_subscription(
        Float64MultiArray,
        f"/ur/joint{i}_effort_controller/commands",
        lambda message, i=i: heard.__setitem__(i, message.data[0]),
        10,
    )
deadline = time.monotonic() + 30
while len(heard) < n:
    if time.monotonic() > deadline:
        raise SystemExit(f"no torque for joints {sorted(set(range(1, n + 1)) - set(heard))}")
    rclpy.spin_once(node, timeout_sec=0.1)
json.dump([heard[i] for i in range(1, n + 1)], sys.stdout)
