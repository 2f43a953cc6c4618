"""Runs as animations: for a page, for Foxglove, for a document."""
