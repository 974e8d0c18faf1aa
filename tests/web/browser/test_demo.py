#  SPDX-License-Identifier: GPL-3.0-or-later
"""The demo, as it is begun by whoever tries the program first."""

import os
import signal
import time
from pathlib import Path

from conftest import Visitors
from parties import LIMIT, ROOT, Child

BUILD = 600.0
#  Seconds

LEFT_ALONE = 125.0
#  Seconds: after 120 without a command a robot switches itself off


def test_left_alone(tmp_path: Path, visitors: Visitors) -> None:
    """It starts at the first click, whenever that is, though its terminal is closed."""
    visitors.excuse("/ws")  # the page may see the end of the demo
    before = ["setsid", "nohup", "env", f"TMPDIR={tmp_path}"]
    demo = Child(ROOT / "script/demo", "--web", before=before)
    try:
        address = demo.line(r"^ +(http://\S*\w)", within=BUILD)[1]
        os.killpg(demo.process.pid, signal.SIGHUP)
        time.sleep(LEFT_ALONE)
        visitors.open(address).start()
    finally:
        demo.process.terminate()
        status = demo.process.wait(LIMIT)
        print(demo.account)
    assert status == 130


def test_each_line_when_it_happens(tmp_path: Path) -> None:
    """In the console: one of each leg, and the result last."""
    demo = Child(ROOT / "script/demo", before=["env", f"TMPDIR={tmp_path}"])
    demo.line("mission: leg 1 of 16", within=BUILD)
    assert not any("supervisor said" in line for line in demo.lines), "all at once"
    demo.line("of 16 points passed", within=BUILD)
    demo.process.wait(LIMIT)
    legs = [line.split(",")[0] for line in demo.lines if "mission: leg" in line]
    said = [line[line.index("leg") :] for line in legs]
    assert len(said) == len(set(said))
    assert any("points passed" in line for line in demo.lines[-2:])
