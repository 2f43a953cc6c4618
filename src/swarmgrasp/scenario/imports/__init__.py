"""What people have, as parts of a scenario: outlines and robots in files of other programs."""
