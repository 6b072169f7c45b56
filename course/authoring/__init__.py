"""For the authors of lessons: notebooks made from solved sources, lessons checked, new lessons begun."""
