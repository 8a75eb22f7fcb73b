"""Text that XML can carry."""

from __future__ import annotations

import re

_ILLEGIBLE = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def legible(text: str) -> str:
    """Text without the characters that XML does not have."""
    return _ILLEGIBLE.sub("\N{REPLACEMENT CHARACTER}", text)
