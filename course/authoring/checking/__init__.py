"""A lesson checked: its notebooks up to date, its answers judged, its cells executed."""
