"""The figures of the course: one function a figure, drawn by the same arms that the equations are checked against."""
