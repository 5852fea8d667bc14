"""Export to Gazebo: ROS packages as values, and `package_folder` to write them.

`templates/` holds each file of a package, with its blanks written @{so}.
"""
