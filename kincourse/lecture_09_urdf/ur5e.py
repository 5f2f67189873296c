"""A URDF of the UR5e in our own words: the numbers of the maker's data sheet, and cylinders for the bodies of the links."""

UR5E = """<robot name="UR5e">
  <link name="base"> <visual> <origin xyz="0 0 0.05"/>
    <geometry> <cylinder radius="0.075" length="0.1"/> </geometry> </visual> </link>
  <joint name="shoulder_pan" type="revolute"> <parent link="base"/> <child link="shoulder"/>
    <origin xyz="0 0 0.1625"/> <axis xyz="0 0 1"/>
    <limit lower="-6.28" upper="6.28" effort="150" velocity="3.14"/> </joint>
  <link name="shoulder"> <visual> <origin xyz="0 -0.04 0" rpy="1.570796326794897 0 0"/>
    <geometry> <cylinder radius="0.06" length="0.2"/> </geometry> </visual> </link>
  <joint name="shoulder_lift" type="revolute"> <parent link="shoulder"/> <child link="upper_arm"/>
    <origin rpy="1.570796326794897 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-6.28" upper="6.28" effort="150" velocity="3.14"/> </joint>
  <link name="upper_arm"> <visual> <origin xyz="-0.2125 0 0.138" rpy="0 1.570796326794897 0"/>
    <geometry> <cylinder radius="0.05" length="0.425"/> </geometry> </visual> </link>
  <joint name="elbow" type="revolute"> <parent link="upper_arm"/> <child link="forearm"/>
    <origin xyz="-0.425 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-3.14" upper="3.14" effort="150" velocity="3.14"/> </joint>
  <link name="forearm"> <visual> <origin xyz="-0.1961 0 0.02" rpy="0 1.570796326794897 0"/>
    <geometry> <cylinder radius="0.04" length="0.3922"/> </geometry> </visual> </link>
  <joint name="wrist_1" type="revolute"> <parent link="forearm"/> <child link="wrist_1_link"/>
    <origin xyz="-0.3922 0 0.1333"/> <axis xyz="0 0 1"/>
    <limit lower="-6.28" upper="6.28" effort="28" velocity="3.14"/> </joint>
  <link name="wrist_1_link"> <visual> <origin xyz="0 0 -0.05"/>
    <geometry> <cylinder radius="0.035" length="0.17"/> </geometry> </visual> </link>
  <joint name="wrist_2" type="revolute"> <parent link="wrist_1_link"/> <child link="wrist_2_link"/>
    <origin xyz="0 -0.0997 0" rpy="1.570796326794897 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-6.28" upper="6.28" effort="28" velocity="3.14"/> </joint>
  <link name="wrist_2_link"> <visual> <origin xyz="0 0 -0.03"/>
    <geometry> <cylinder radius="0.035" length="0.13"/> </geometry> </visual> </link>
  <joint name="wrist_3" type="revolute"> <parent link="wrist_2_link"/> <child link="flange"/>
    <origin xyz="0 0.0996 0" rpy="-1.570796326794897 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-6.28" upper="6.28" effort="28" velocity="3.14"/> </joint>
  <link name="flange"> <visual> <origin xyz="0 0 -0.02"/>
    <geometry> <cylinder radius="0.032" length="0.04"/> </geometry> </visual> </link>
</robot>"""
