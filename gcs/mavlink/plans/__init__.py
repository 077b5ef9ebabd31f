"""Plans of vehicles, missions, fences and rally points: their items, the dialogue about them, autopilots' habits."""
