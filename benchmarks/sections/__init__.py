"""The sections of the page of benchmarks, a file or a few each."""
