"""Runs and studies: computed, read, and their fields."""
