"""The commands of `holonom`: each module has `run(arguments) -> exit code`."""
