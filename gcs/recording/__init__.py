"""Session folder: written while a session flies, read back for report, replay and export."""
