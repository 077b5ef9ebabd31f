"""`gcs campaign`: fly a scenario many times, varied."""
