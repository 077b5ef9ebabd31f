"""The safety filter: accelerations with which vehicles keep apart, for the station and for vehicles."""
