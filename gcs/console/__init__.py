"""What a person watches; a client of the session socket."""
