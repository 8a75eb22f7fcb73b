"""The commands of `build-fmu`: each module has `run(arguments) -> exit code`."""
