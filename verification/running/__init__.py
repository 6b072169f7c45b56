"""Many documents, on several cores, watched while they are written; files that are whole or not there."""
