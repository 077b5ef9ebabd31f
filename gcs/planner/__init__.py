"""Where each vehicle goes next: potential field, fuzzy escape, formation."""
