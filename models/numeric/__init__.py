"""The kinematics of an arm in doubles: Drake's plant at many configurations."""
