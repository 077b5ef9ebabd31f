"""How long tests wait for processes, peers and pages: only a failure takes that long, on a busy machine too."""

PATIENCE_S = 90.0
