"""Parameter studies: values from files and grids, families of FMUs, one FMU run many times."""
