"""Pages of the site that are written from scenes and from the table of a scene's parts."""
