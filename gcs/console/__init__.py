"""Console: a Textual client of the session socket."""
