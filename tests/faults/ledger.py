#  SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that every command of a session is answered exactly once, in order,
although some answers look like unsolicited messages. It follows all interpretations
in parallel: a message that may be either is taken as both, until others decide."""

import time
from dataclasses import dataclass, field

USUAL = frozenset(("AACK", "ANAK", "ACRJ", "ATIM", "ACER"))
ANSWERS = {
    "usual": USUAL,
    "battery": USUAL | {"RBLV"},  # which is also sent unsolicited
    "state": USUAL | {"RCST"},
    "arena": USUAL | {"CIMG"},  # which is also sent unsolicited
    "refused": frozenset(("ACER",)),
    "perhaps": frozenset(("ACER",)),  # or nothing
    "silent": frozenset[str](),  # nothing
}
UNASKED = frozenset(("CIMG", "CPOS", "RBLV", "MSSG", "MPRG", "MEND", "ATIM"))
KINDS = {"RGBT": "battery", "RGST": "state", "CASA": "arena"} | dict.fromkeys(
    ("CACO", "CAIN", "LIVE", "MSSG"), "silent"
)
SHOWN = 60
#  Characters of a command or of a message in a complaint


@dataclass
class Message:
    """time: when the recv that completed it returned."""

    label: str
    data: str = ""
    time: float = field(default_factory=time.monotonic)


def kind_of(command: str) -> str:
    """Of a well-formed command."""
    return KINDS.get(command[:4], "usual")


def printable(text: str) -> str:
    return "".join(c if " " <= c <= "~" else "?" for c in text[:SHOWN])


class Ledger:
    def __init__(self) -> None:
        self.sent: list[tuple[str, str, float]] = []
        self.breach = ""
        #  the line that caused it
        self._costs = {0: 0}
        #  by how many commands may be answered: the smallest number of unsolicited
        #  ATIM that is consistent with the messages so far

    def put_command(self, text: str, kind: str) -> None:
        """It will be sent now."""
        self.sent.append((text, kind, time.monotonic()))
        self._pass_over()

    def _pass_over(self) -> None:
        """What may go without an answer."""
        for number in sorted(self._costs):
            while number in self._costs and number < len(self.sent):
                kind = self.sent[number][1]
                if kind not in ("perhaps", "silent"):
                    break
                self._take(number + 1, self._costs[number])
                if kind == "silent":
                    #  there is but one way
                    del self._costs[number]
                number += 1

    def _take(self, number: int, cost: int) -> None:
        self._costs[number] = min(cost, self._costs.get(number, cost))

    def put_message(self, item: Message) -> None:
        if self.breach:
            return
        before, self._costs = self._costs, {}
        for number, cost in before.items():
            if item.label in UNASKED:
                self._take(number, cost + (item.label == "ATIM"))
            if number < len(self.sent):
                _, kind, since = self.sent[number]
                if since <= item.time and item.label in ANSWERS[kind]:
                    self._take(number + 1, cost)
        if self._costs:
            self._pass_over()
        else:
            self._costs = before
            self.breach = (
                f"{item.label}:{printable(item.data)} answers no command: after"
                f" {len(self.sent)} commands, of which {min(before)} had been answered"
                f"; the next was {self.first_waiting}"
            )

    @property
    def complete(self) -> bool:
        """No command waits for its answer."""
        return not self.breach and len(self.sent) in self._costs

    @property
    def unasked_losses(self) -> int:
        """The least number of unsolicited ATIM: one for each loss of the robot."""
        ways = self._costs
        return ways[len(self.sent)] if self.complete else min(ways.values())

    @property
    def waiting(self) -> int:
        """Commands that certainly have no answer."""
        return len(self.sent) - min(self._costs)

    @property
    def first_waiting(self) -> str:
        return printable(self.sent[min(self._costs)][0]) if self.waiting else ""
