"""Scenarios, their parameters and what may stand in them."""
