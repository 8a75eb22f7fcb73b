"""Other codes on the same problems, each where its package is."""
