#  SPDX-License-Identifier: GPL-3.0-or-later
"""What a fault is."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from functools import partial
from typing import Any

from world import Robot, World

Ends = IntEnum("Ends", "NOTHING SESSION_MAY_END SESSION SUPERVISOR")
#  The session continues, every command is answered; both are right; it ends, and the
#  supervisor detects it in time; the supervisor, with the status that inject announced

ONCE = frozenset(("launcher", "copied", "camera", "emulator_options", "through_link"))
#  Of a plan: two faults that change the start need different worlds


Action = Callable[[World], None]


def nothing(_: World) -> None:
    pass


def telling(command: str) -> Action:
    """The emulator."""
    return partial(World.tell, command=command)


@dataclass(frozen=True)
class Fault:
    group: str
    name: str
    #  as in the table, such as "stall of 5 s"
    inject: Action
    #  at a random time of a session. Sets in the world what the checks must know, such
    #  as lose, expected_end, line_works
    lift: Action = nothing
    #  removes it; the checks follow. Also called if inject failed
    in_pair: Action | None = None
    #  instead of inject, where the monitor may be absent and another fault active
    plan: Mapping[str, Any] = field(default_factory=dict)
    #  how the programs must be started for it
    cost: float = 1.0
    #  approximate seconds of inject and lift: long ones are started first
    ends: Ends = Ends.NOTHING
    robot: Robot = Robot.CLOSED
    #  at least, when the fault comes
    camera: bool | None = None
    #  whether it must stream then, or must be closed
    heavy: bool = False
    #  takes a processor: at most two at a time
    alone: bool = False
    #  not combined with others


def go_together(first: Fault, second: Fault) -> bool:
    """In this order."""
    return (
        first.name != second.name
        and not (first.alone or second.alone)
        #  nothing can follow that
        and first.ends is not Ends.SUPERVISOR
        and not ONCE & first.plan.keys() & second.plan.keys()
        and {first.camera, second.camera} != {True, False}
    )
