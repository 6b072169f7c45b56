"""The exact kinematics of an arm: polynomials traced through its symbolic plant."""
