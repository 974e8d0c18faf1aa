#  SPDX-License-Identifier: GPL-3.0-or-later
"""Which answer belongs to which command."""

import pytest
from destijl_web.exchange import CAMERA_LIMIT, ROBOT_LIMIT, Command, Exchange


def sent(*labels: str) -> Exchange:
    exchange = Exchange()
    for label in labels:
        exchange.sent(Command(label), 10.0)
    return exchange


def match(exchange: Exchange, line: bytes, begun_at: float = 11.0) -> list[str]:
    return [c.label for c in exchange.match(line, begun_at, 11.0)]


@pytest.mark.parametrize("answer", [b"AACK", b"ANAK", b"ACRJ", b"ACER"])
def test_answers_of_all(answer: bytes) -> None:
    assert match(sent("COPN"), answer) == ["COPN"]
    assert match(sent("RGFW"), answer) == ["RGFW"]
    assert match(sent("CASA"), answer) == ["CASA"]
    assert match(sent(), answer) == []
    assert match(sent("RGFW"), answer + b"X") == []


def test_in_their_order() -> None:
    exchange = sent("ROPN", "RGBT", "RVER", "RGST")
    assert match(exchange, b"RCST:1") == []
    assert match(exchange, b"RBLV:2") == []
    assert match(exchange, b"AACK") == ["ROPN"]
    assert match(exchange, b"RCST:1") == []
    assert match(exchange, b"RBLV:2") == ["RGBT"]
    assert match(exchange, b"RBLV:2") == []
    assert match(exchange, b"RCST:1") == []
    assert match(exchange, b"RVER:3.5") == ["RVER"]
    assert match(exchange, b"RCST:1") == ["RGST"]


def test_loss_of_the_robot_answers_its_commands_only() -> None:
    assert match(sent("CASA"), b"ATIM") == []
    assert match(sent("COPN", "RGFW"), b"ATIM") == []
    assert match(sent("RGFW"), b"ATIM") == ["RGFW"]
    assert match(sent("MABT"), b"ATIM") == ["MABT"]
    assert match(sent("MGTO"), b"ATIM") == []


def test_images_answer_the_search_only() -> None:
    assert match(sent("COPN"), b"CIMG:/9j/") == []
    assert match(sent("CASA"), b"CIMG:/9j/") == ["CASA"]


def test_an_image_under_way_is_no_answer() -> None:
    assert match(sent("CASA"), b"CIMG:/9j/", begun_at=9.9) == []


def test_what_has_no_answer_waits_for_what_was_sent_before() -> None:
    exchange = Exchange()
    assert [c.label for c in exchange.sent(Command("CACO"), 1.0)] == ["CACO"]
    assert exchange.sent(Command("CASA"), 1.0) == []
    assert exchange.sent(Command("CACO"), 1.0) == []
    assert exchange.sent(Command("RSTP"), 1.0) == []
    assert match(exchange, b"CIMG:/9j/") == ["CASA", "CACO"]
    assert match(exchange, b"AACK") == ["RSTP"]


def test_overdue_from_its_turn_on() -> None:
    exchange = Exchange()
    assert exchange.overdue(1e9) is None
    exchange.sent(Command("COPN"), 0.0)
    exchange.sent(Command("RGFW"), 0.0)
    assert exchange.overdue(CAMERA_LIMIT - 0.1) is None
    late = exchange.overdue(CAMERA_LIMIT + 0.1)
    assert late is not None and late.label == "COPN"
    exchange.match(b"AACK", 14.0, 14.0)
    assert exchange.overdue(14.0 + ROBOT_LIMIT - 0.1) is None
    late = exchange.overdue(14.0 + ROBOT_LIMIT + 0.1)
    assert late is not None and late.label == "RGFW"


def test_lines() -> None:
    assert Command("RGFW").line() == b"RGFW\n"
    assert Command("RTRN", -90).line() == b"RTRN:-90\n"
    points = ((1.0, 2.0), (-0.25, 9999.0))
    assert Command("MPTH", points=points).line() == b"MPTH:1.0;2.0;-0.2;9999.0\n"
