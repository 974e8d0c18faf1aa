#  SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the ledger verifies that every command is answered exactly once."""

import time

import pytest
from ledger import Ledger, Message, kind_of

#  Commands, each with a question mark or with the kind of its answer, and messages;
#  then what is known: "complete", "broken", or how many commands wait
CASES = [
    ("", "complete"),
    ("RPIN? RGST?", 2),
    ("RPIN? RGST? AACK", 1),
    ("RPIN? RGST? AACK RCST", "complete"),
    ("RPIN? AACK AACK", "broken"),
    ("RGST? RPIN? RPIN? RCST AACK", 1),
    ("RPIN? RGST? RCST", "broken"),
    ("rpin?refused AACK", "broken"),
    #  unsolicited messages
    ("RPIN? CIMG CPOS MSSG RBLV", 1),
    ("RPIN? CIMG CPOS MSSG RBLV ANAK CIMG", "complete"),
    #  the unsolicited level comes first, the answer is a refusal
    ("RGBT? RPIN? RBLV ANAK", "complete"),
    ("RGBT? RPIN? RBLV ANAK ANAK", "complete"),
    ("RGBT? RPIN? RBLV ANAK ANAK ANAK", "broken"),
    ("RGBT? RPIN? AACK", 1),
    #  an image from before, of the arena, none of it
    ("CIMG CASA?", 1),
    ("CIMG CASA? CIMG CIMG", "complete"),
    ("CIMG CASA? CIMG CIMG CASA? ANAK", "complete"),
    #  no answer is due
    ("CACO? MSSG:text?", "complete"),
    ("CACO? MSSG:text? RPIN?", 1),
    ("CACO? MSSG:text? RPIN? AACK", "complete"),
    ("CACO? MSSG:text? RPIN? AACK CAIN? AACK", "broken"),
    #  both are right, but once
    ("MSSG:long?perhaps RPIN? ACER AACK", "complete"),
    ("MSSG:long?perhaps RPIN? ACER AACK ACER", "broken"),
    ("MSSG:long?perhaps RPIN? AACK", "complete"),
    ("MSSG:long?perhaps RPIN? AACK ACER", "broken"),
]


def heard(words: str) -> Ledger:
    ledger = Ledger()
    for word in words.split():
        command, asked, kind = word.partition("?")
        if asked:
            ledger.put_command(command, kind or kind_of(command))
        else:
            ledger.put_message(Message(word))
    return ledger


@pytest.mark.parametrize(("words", "known"), CASES)
def test_once(words: str, known: str | int) -> None:
    ledger = heard(words)
    assert ledger.complete is (known == "complete")
    assert bool(ledger.breach) is (known == "broken")
    if isinstance(known, int):
        assert ledger.waiting == known


def test_which_waits() -> None:
    assert heard("RPIN? RGST? AACK").first_waiting == "RGST"


def test_too_early() -> None:
    ledger = Ledger()
    before = time.monotonic()
    ledger.put_command("RPIN", "usual")
    ledger.put_message(Message("AACK", time=before))
    assert ledger.breach


def test_loss_of_robot() -> None:
    assert heard("RPIN? ATIM").unasked_losses == 0
    assert heard("RPIN? ATIM ATIM").unasked_losses == 1
    ledger = heard("RPIN? ATIM ATIM RPIN? ANAK")
    assert ledger.complete
    assert ledger.unasked_losses == 1
