"""Walks through data as TOML and JSON give it."""


def paths_of(data, path=()):
    """Every path of nested data."""
    items = data.items() if isinstance(data, dict) else enumerate(data)
    for key, value in items:
        yield (*path, key), value
        if isinstance(value, (dict, list)):
            yield from paths_of(value, (*path, key))
