"""Version of the tool: of the package and, as generating tool, in its FMUs."""

VERSION = "2.0.0"
