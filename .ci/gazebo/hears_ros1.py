"""A ROS 1 node that hears one torque a joint and prints them as JSON: hears_ros1.py N"""

from __future__ import annotations

import json
import sys

import rospy
from std_msgs.msg import Float64

rospy.init_node("ear")
topics = [f"/ur/joint{i}_effort_controller/command" for i in range(1, int(sys.argv[1]) + 1)]
json.dump([rospy.wait_for_message(topic, Float64, timeout=30).data for topic in topics], sys.stdout)
