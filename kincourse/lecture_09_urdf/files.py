"""Files of lecture 09 in our own words: the UR5e, by its maker's data sheet and with cylinders for bodies, a camera, and a four-bar."""

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

ARM = """<robot name="camera">
  <link name="base"/> <link name="mast"/> <link name="camera"/>
  <joint name="pan" type="revolute"> <parent link="base"/> <child link="mast"/>
    <origin xyz="0 0 0.5"/> <axis xyz="0 0 1"/>
    <limit lower="-2" upper="2" effort="10" velocity="1"/> </joint>
  <joint name="tilt" type="revolute"> <parent link="mast"/> <child link="camera"/>
    <origin xyz="0 0 0.2" rpy="-1.5708 0 0"/> <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/> </joint>
</robot>"""
"""A camera that pans and tilts: a valid file."""

FOUR_BAR = """<robot name="four-bar">
  <link name="ground"/> <link name="crank"/> <link name="coupler"/> <link name="rocker"/>
  <joint name="A" type="continuous"> <parent link="ground"/> <child link="crank"/> <axis xyz="0 0 1"/> </joint>
  <joint name="B" type="continuous"> <parent link="crank"/> <child link="coupler"/>
    <origin xyz="1 0 0"/> <axis xyz="0 0 1"/> </joint>
  <joint name="C" type="continuous"> <parent link="coupler"/> <child link="rocker"/>
    <origin xyz="2 0 0"/> <axis xyz="0 0 1"/> </joint>
  <joint name="D" type="continuous"> <parent link="ground"/> <child link="rocker"/>
    <origin xyz="3 0 0"/> <axis xyz="0 0 1"/> </joint>
</robot>"""
"""A four-bar linkage, whose rocker has two parents: not a tree."""
