"""xacro"""
