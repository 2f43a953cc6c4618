"""The measurements behind the report, each with the statements that rest on it."""
