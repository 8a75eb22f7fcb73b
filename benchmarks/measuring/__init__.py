"""Time, instructions and memory of a process, and programs that are measured."""
