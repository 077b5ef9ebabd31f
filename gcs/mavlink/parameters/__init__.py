"""Parameters: their values and types, the dialogue about them, their files and their old names."""
