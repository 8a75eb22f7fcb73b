"""Native FMUs on other platforms: run where an emulator is installed, else looked into."""
