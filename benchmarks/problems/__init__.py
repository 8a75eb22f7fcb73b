"""The problems that are measured, and where they are at their end."""
