"""Names as they are compared: two spellings that Unicode calls equal are one name."""

from __future__ import annotations

import unicodedata


def nfc(text: str) -> str:
    r"""A text in Unicode's composed form (NFC), in which names are compared.

    >>> nfc("cafe\u0301") == "caf\u00e9"
    True
    """
    return text if text.isascii() else unicodedata.normalize("NFC", text)
