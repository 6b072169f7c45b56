"""Robot-arm kinematics checked against Drake."""
