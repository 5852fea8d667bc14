"""A small arm with all that engines are known to read in their own way."""

ARM = """\
<robot name="three">
  <link name="base">
    <inertial>
      <mass value="4"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <joint name="pan" type="revolute">
    <parent link="base"/><child link="upper"/><origin xyz="0 0 0.3" rpy="0 0 0.4"/>
    <axis xyz="0 0 1"/><limit lower="-2" upper="2.5" velocity="3" effort="100"/>
    <dynamics damping="0.5" friction="0.2"/>
  </joint>
  <link name="upper">
    <inertial>
      <origin xyz="0.1 0.02 0" rpy="0.3 -0.2 0.5"/><mass value="2.5"/>
      <inertia ixx="0.01" ixy="0.001" ixz="0" iyy="0.03" iyz="0" izz="0.032"/>
    </inertial>
  </link>
  <joint name="lift" type="revolute">
    <parent link="upper"/><child link="lower"/><origin xyz="0.4 0 0" rpy="1.5707963267948966 0 0"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="3" effort="60"/>
  </joint>
  <link name="lower">
    <inertial>
      <origin xyz="0 0.15 0" rpy="0 0 1.1"/><mass value="1.5"/>
      <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.012" iyz="0" izz="0.013"/>
    </inertial>
  </link>
  <joint name="fix" type="fixed">
    <parent link="lower"/><child link="plate"/><origin xyz="0.05 0 0" rpy="0 0.3 0"/>
  </joint>
  <link name="plate">
    <collision><origin xyz="0 0 0.05"/><geometry><box size="0.1 0.2 0.3"/></geometry></collision>
  </link>
  <joint name="roll" type="continuous">
    <parent link="lower"/><child link="hand"/><origin xyz="0 0.3 0" rpy="0.2 0.1 0"/>
    <axis xyz="1 0 0"/>
  </joint>
  <link name="hand">
    <inertial>
      <origin xyz="0 0 0.04"/><mass value="0.6"/>
      <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.0015"/>
    </inertial>
  </link>
  <joint name="hang" type="fixed">
    <parent link="hand"/><child link="weight"/><origin xyz="0 0 0.1"/>
  </joint>
  <link name="weight">
    <inertial>
      <origin xyz="0.01 0 0" rpy="0.4 0 0"/><mass value="0.3"/>
      <inertia ixx="0.0002" ixy="0" ixz="0" iyy="0.0004" iyz="0" izz="0.0005"/>
    </inertial>
  </link>
  <joint name="end" type="fixed">
    <parent link="hand"/><child link="tool"/><origin xyz="0 0 0.2"/>
  </joint>
  <link name="tool"/>
</robot>
"""
