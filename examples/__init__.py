"""Co-simulations of several FMUs, with the energy that crosses between them."""
