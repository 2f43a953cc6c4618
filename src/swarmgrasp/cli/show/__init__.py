"""How answers are told to people: one file per kind of answer."""
