"""DH tables, classic and modified: read, validated, built as a MultibodyPlant."""
