#  SPDX-License-Identifier: GPL-3.0-or-later
"""Tokens, sessions, attempts."""

import pytest
from destijl_web.logins import (
    ATTEMPTS,
    EXPULSION,
    LIFE,
    MAX_SESSIONS,
    RECOVERY,
    Budget,
    Logins,
    Refused,
    Session,
)

HERE = "192.0.2.1"


def both() -> Logins:
    return Logins("teacher-token", "viewer-token")


def role(logins: Logins, name: str | None, now: float = 1.0) -> str | None:
    session = logins.session(name, now)
    return None if session is None else session.role


def refused(logins: Logins, token: str, address: str, now: float = 0.0) -> str:
    with pytest.raises(Refused) as reason:
        logins.log_in(token, address, now)
    return str(reason.value)


def test_open() -> None:
    logins = Logins(None, None)
    assert role(logins, None) == "open"
    assert refused(logins, "", HERE) == "1"


def test_roles() -> None:
    logins = both()
    assert role(logins, None) is None
    assert role(logins, "made up") is None
    teacher = logins.log_in("teacher-token", HERE, 0.0)
    viewer = logins.log_in("viewer-token", HERE, 0.0)
    assert teacher != viewer
    assert role(logins, teacher) == "teacher"
    assert role(logins, viewer) == "viewer"
    assert role(logins, viewer, LIFE + 1.0) is None


def test_wrong_tokens() -> None:
    logins = Logins("teacher-token", None)
    for wrong in ("", "teacher-toke", "teacher-token ", "TEACHER-TOKEN", "\udc80"):
        assert refused(logins, wrong, HERE) == "1"


def test_attempts_are_limited() -> None:
    """But the right token is not among them."""
    logins = Logins("teacher-token", None)
    for _ in range(ATTEMPTS):
        assert refused(logins, "wrong", HERE) == "1"
    assert refused(logins, "wrong", HERE) == "wait"
    assert role(logins, logins.log_in("teacher-token", HERE, 0.0)) == "teacher"
    assert refused(logins, "wrong", "192.0.2.2") == "1"
    assert refused(logins, "wrong", HERE, RECOVERY * 0.9) == "wait"
    assert refused(logins, "wrong", HERE, RECOVERY * 1.1) == "1"


def test_sources() -> None:
    """A network of IPv6 is one; so is all that is no address."""
    logins = Logins("teacher-token", None)
    for number in range(ATTEMPTS):
        refused(logins, "wrong", f"2001:db8::{number}")
        refused(logins, "wrong", f"garbage {number}")
        refused(logins, "wrong", "::ffff:" + HERE)
    for same in ("2001:db8::ffff", "", "192.0.2.256", HERE):
        assert refused(logins, "wrong", same) == "wait"
    for other in ("2001:db8:1::1", "::ffff:192.0.2.2", "fe80::1%eth0"):
        assert refused(logins, "wrong", other) == "1"


def test_sessions_are_bounded() -> None:
    """In each role, and none goes that is used."""
    logins = both()
    teacher = logins.log_in("teacher-token", HERE, 0.0)
    watching, first, *others = (
        logins.log_in("viewer-token", HERE, 0.0) for _ in range(2)
    )
    session = logins.session(watching, 0.0)
    assert session is not None
    session.sockets = 1
    others += [logins.log_in("viewer-token", HERE, 0.0) for _ in range(MAX_SESSIONS)]
    assert role(logins, teacher) == "teacher"
    assert role(logins, watching) == "viewer"
    assert role(logins, first) is None
    assert sum(role(logins, one) is not None for one in others) == MAX_SESSIONS - 1
    assert role(logins, others[-1]) == "viewer"


def test_logged_out() -> None:
    logins = both()
    name = logins.log_in("teacher-token", HERE, 0.0)
    session = logins.session(name, 1.0)
    assert session is not None and session.until > 1.0
    logins.log_out(name)
    assert role(logins, name) is None and session.until <= 1.0
    logins.log_out(name)
    logins.log_out(None)


def expelled(logins: Logins, name: str) -> None:
    session = logins.session(name, 1.0)
    assert session is not None
    logins.expel(session, 1.0)


def test_expelled_with_its_address() -> None:
    logins = both()
    pupil, again = (logins.log_in("viewer-token", HERE, 0.0) for _ in range(2))
    other = logins.log_in("viewer-token", "192.0.2.2", 0.0)
    teacher = logins.log_in("teacher-token", HERE, 0.0)
    expelled(logins, pupil)
    assert [role(logins, one) for one in (pupil, again, other, teacher)] == [
        *(None, None, "viewer", "teacher")
    ]
    assert refused(logins, "viewer-token", HERE, 2.0) == "expelled"
    assert role(logins, logins.log_in("teacher-token", HERE, 2.0)) == "teacher"
    logins.log_in("viewer-token", HERE, 1.0 + EXPULSION)


@pytest.mark.parametrize("local", ["127.0.0.1", "::1"])
def test_expelled_from_this_machine(local: str) -> None:
    """Its address is that of all who come through a tunnel."""
    logins = both()
    pupil, other = (logins.log_in("viewer-token", local, 0.0) for _ in range(2))
    expelled(logins, pupil)
    assert [role(logins, one) for one in (pupil, other)] == [None, "viewer"]
    logins.log_in("viewer-token", local, 2.0)


def test_a_budget() -> None:
    budget = Budget(2.0, 0.5)
    assert [budget.take(10.0) for _ in range(3)] == [True, True, False]
    assert [budget.take(12.0) for _ in range(2)] == [True, False]
    assert [budget.take(1000.0) for _ in range(3)] == [True, True, False]
    assert budget.take(1003.0, 1.5) and not budget.take(1003.0, 0.5)


def test_sessions_share_no_budget() -> None:
    one, other = Session("viewer"), Session("viewer")
    while one.stops.take(0.0):
        pass
    assert other.stops.take(0.0)
