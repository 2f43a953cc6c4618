"""Other ways to a quality or to a placement, as a careful user would write them."""
