"""`gcs mission`: plans of files, recordings and whole fleets."""
