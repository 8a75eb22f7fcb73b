"""Which laws of contact each code keeps, in small experiments of one impact or of rest."""
