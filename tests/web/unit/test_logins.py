#  SPDX-License-Identifier: GPL-3.0-or-later
"""Tokens, sessions, attempts."""

from destijl_web.logins import ATTEMPTS, LIFE, MAX_SESSIONS, RECOVERY, Logins

HERE = "192.0.2.1"


def test_open() -> None:
    logins = Logins(None, None)
    assert logins.role(None, 0.0) == "open"
    assert logins.log_in("", HERE, 0.0) is None


def test_roles() -> None:
    logins = Logins("teacher-token", "viewer-token")
    assert logins.role(None, 0.0) is None
    assert logins.role("made up", 0.0) is None
    teacher = logins.log_in("teacher-token", HERE, 0.0)
    viewer = logins.log_in("viewer-token", HERE, 0.0)
    assert teacher and viewer and teacher != viewer
    assert logins.role(teacher, 1.0) == "teacher"
    assert logins.role(viewer, 1.0) == "viewer"
    assert logins.role(viewer, LIFE + 1.0) is None


def test_wrong_tokens() -> None:
    logins = Logins("teacher-token", None)
    for wrong in ("", "teacher-toke", "teacher-token ", "TEACHER-TOKEN", "\udc80"):
        assert logins.log_in(wrong, HERE, 0.0) is None


def test_attempts_are_limited() -> None:
    logins = Logins("teacher-token", None)
    for _ in range(ATTEMPTS):
        assert logins.may_try(HERE, 0.0)
        logins.log_in("wrong", HERE, 0.0)
    assert not logins.may_try(HERE, 0.0)
    assert logins.may_try("192.0.2.2", 0.0)
    assert not logins.may_try(HERE, RECOVERY * 0.9)
    assert logins.may_try(HERE, RECOVERY * 1.1)


def test_a_network_of_ipv6_is_one_source() -> None:
    logins = Logins("teacher-token", None)
    for number in range(ATTEMPTS):
        logins.log_in("wrong", f"2001:db8::{number}", 0.0)
    assert not logins.may_try("2001:db8::ffff", 0.0)
    assert logins.may_try("2001:db8:1::1", 0.0)


def test_sessions_are_bounded() -> None:
    logins = Logins("teacher-token", None)
    sessions = [logins.log_in("teacher-token", HERE, 0.0) for _ in range(1001)]
    assert len(sessions) == MAX_SESSIONS + 1
    assert logins.role(sessions[0], 0.0) is None
    assert logins.role(sessions[-1], 0.0) == "teacher"
