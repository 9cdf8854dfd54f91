"""From measured numbers to parameters: ``matrigrate.calibrate`` is the door."""
