#  SPDX-License-Identifier: GPL-3.0-or-later
"""The version of all that is released together."""

import re
from pathlib import Path

_HERE = Path(__file__).resolve().parent


def number() -> str:
    """From the file VERSION beside the package, which the package build
    writes, or from its one place in the tree."""
    installed = _HERE.parent / "VERSION"
    if installed.is_file():
        return installed.read_text(encoding="ascii").strip()
    source = _HERE.parents[2] / "src" / "common" / "project_version.ads"
    found = re.search(r'Number : .*"(.*)";', source.read_text(encoding="ascii"))
    if found is None:
        raise RuntimeError(f"no version in {source}")
    return found.group(1)
