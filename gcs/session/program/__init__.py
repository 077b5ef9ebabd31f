"""A program in Python that steps a session: both ends of its channel, and what passes between them."""
