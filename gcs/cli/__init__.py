"""Commands of `gcs`; each loads what it needs when it runs."""
