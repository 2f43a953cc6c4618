"""The page: everything the program knows of a scenario, to be seen and moved in a browser."""
