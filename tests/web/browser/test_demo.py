#  SPDX-License-Identifier: GPL-3.0-or-later
"""The demo, as it is begun by whoever tries the program first."""

import time
from pathlib import Path

from conftest import Visitors
from stand import LIMIT, ROOT, Child

BUILD = 600.0
#  Seconds

LEFT_ALONE = 125.0
#  Seconds: after 120 without a command a robot switches itself off


def test_left_alone(tmp_path: Path, visitors: Visitors) -> None:
    """It starts at the first click, whenever that is."""
    visitors.excuse("/ws")  # the page may see the end of the demo
    demo = Child(ROOT / "script/demo", "--web", before=["env", f"TMPDIR={tmp_path}"])
    try:
        address = demo.line(r"^ +(http://\S*\w)", within=BUILD)[1]
        time.sleep(LEFT_ALONE)
        visitors.open(address).start()
    finally:
        demo.process.terminate()
        status = demo.process.wait(LIMIT)
        print(demo.account)
    assert status == 130
