"""Flight law of one vehicle: plant, differentiator, two loops, guidance and power as pure, compiled functions."""
