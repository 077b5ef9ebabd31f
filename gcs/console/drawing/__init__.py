"""Drawings made of characters: canvas, curves, panels."""
