"""The statements of a display: what each claims, and whether it holds."""
