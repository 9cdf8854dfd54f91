"""What ``matrigrate.plot`` and reports are drawn with."""
