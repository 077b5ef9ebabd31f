"""The page of a flight in a browser: live, replayed, or recorded in report.html."""
