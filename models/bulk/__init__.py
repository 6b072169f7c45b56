"""The kinematics of an arm at millions of configurations: exact traces compiled to NumPy."""
