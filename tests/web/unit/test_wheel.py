#  SPDX-License-Identifier: GPL-3.0-or-later
"""Who drives, and when the robot is stopped for it."""

import pytest
from destijl_web import hub
from helpers import TOKENS, World


async def stops(w: World, count: int) -> None:
    """So many stops have been sent, and no more."""
    await w.supervisor.heard("RSTP", count)
    assert w.supervisor.count("RSTP") == count


async def test_one_drives(w: World) -> None:
    driver, other = await w.started()
    await driver.event("wheel_taken", name="#1")
    for label in ("RGFW", "RCLS", "COPN", "CACO"):
        assert (await other.order(label))["answer"] == "NOWHEEL"
    assert (await driver.order("RGFW"))["answer"] == "AACK"
    await other.wheel("take")
    await other.settle()
    assert w.service.hub.state["driver"] == driver.number
    assert w.supervisor.count("RGFW") == 1
    assert w.supervisor.count("RCLS") == 0


async def test_everybody_may_stop(w: World) -> None:
    driver, other = await w.started()
    assert (await other.order("RSTP"))["answer"] == "AACK"
    await driver.event("stopped_by", name="#2")
    await stops(w, 1)
    assert (await driver.order("RSTP"))["answer"] == "AACK"
    await driver.settle()
    told = [s for s in driver.said if s.get("code") == "stopped_by"]
    assert len(told) == 1


async def test_asked_and_given(w: World) -> None:
    driver = await w.driver()
    one, two = await w.page(), await w.page()
    await w.start_robot(driver)
    await two.wheel("ask")
    await driver.event("wheel_asked", name="#3")
    await one.wheel("ask")
    await one.wheel("ask")
    await driver.state(asking=[3, 2])
    await driver.wheel("decline", to=3)
    await two.event("wheel_declined", name="#3")
    await driver.state(asking=[2])
    #  who does not drive gives nothing, and only who asks gets it
    await one.wheel("give", to=2)
    await one.settle()
    await driver.wheel("give", to=3)
    await driver.wheel("give", to=77)
    await driver.settle()
    assert w.service.hub.state["driver"] == 1
    await driver.wheel("give", to=2)
    await driver.event("wheel_given", **{"from": "#1", "name": "#2"})
    await driver.state(driver=2, asking=[])
    await stops(w, 1)
    assert (await driver.order("RGFW"))["answer"] == "NOWHEEL"
    assert (await one.order("RGFW"))["answer"] == "AACK"


async def test_a_request_is_withdrawn(w: World) -> None:
    driver, other = await w.driver(), await w.page()
    await other.wheel("ask")
    await driver.state(asking=[2])
    await other.wheel("withdraw")
    await other.settle()
    await driver.state(asking=[])
    await driver.wheel("give", to=2)
    await driver.settle()
    assert w.service.hub.state["driver"] == 1


async def test_offered_to_anybody(w: World) -> None:
    """Who has not asked gets it only by taking it; nobody else does."""
    driver, other = await w.started()
    third = await w.page()
    await other.wheel("offer", to=3)
    await driver.wheel("offer", to=77)
    await driver.wheel("offer", to=1)
    await driver.settle()
    await other.settle()
    assert w.service.hub.state["offered"] is None
    await driver.wheel("offer", to=3)
    await other.event("wheel_offered", **{"from": "#1", "name": "#3"})
    await other.wheel("take")
    await other.settle()
    assert w.service.hub.state["driver"] == 1
    assert w.supervisor.count("RSTP") == 0
    await third.wheel("take")
    await driver.event("wheel_given", **{"from": "#1", "name": "#3"})
    await driver.state(driver=3, offered=None)
    await stops(w, 1)
    assert (await driver.order("RGFW"))["answer"] == "NOWHEEL"


async def test_an_offer_ends(w: World) -> None:
    """By either of the two, and with either."""
    driver, other = await w.started()
    third = await w.page()

    async def offer() -> None:
        await driver.wheel("offer", to=3)
        await driver.state(offered=3)

    await offer()
    await other.wheel("withdraw")
    await other.settle()
    assert w.service.hub.state["offered"] == 3
    await third.wheel("withdraw")
    await driver.event("wheel_unwanted", name="#3")
    await driver.state(offered=None)
    await offer()
    await driver.wheel("withdraw")
    await driver.state(offered=None)
    await third.wheel("take")
    await third.settle()
    assert w.service.hub.state["driver"] == 1
    await offer()
    await third.close()
    await driver.state(offered=None)
    await driver.wheel("offer", to=2)
    await other.state(offered=2)
    await driver.wheel("release")
    await other.state(driver=None, offered=None)


async def test_asking_for_a_free_wheel_takes_it(w: World) -> None:
    page = await w.page()
    await page.wheel("ask")
    await page.event("wheel_taken", name="#1")
    await page.state(driver=1)


async def test_released(w: World) -> None:
    driver, other = await w.started()
    await other.wheel("release")
    await other.settle()
    assert w.service.hub.state["driver"] == 1
    await driver.wheel("release")
    await other.event("wheel_released", name="#1")
    await other.state(driver=None)
    await stops(w, 1)
    await other.wheel("take")
    await other.state(driver=2)
    await stops(w, 1)


async def test_no_stop_for_a_robot_that_is_not_open(w: World) -> None:
    driver = await w.driver()
    await driver.wheel("release")
    await driver.state(driver=None)
    await driver.settle()
    assert w.supervisor.count("RSTP") == 0


async def test_stop_for_a_robot_that_is_being_started(w: World) -> None:
    driver = await w.driver()
    w.supervisor.answers["ROPN"] = None
    for number, label in enumerate(("ROPN", "RSOW", "RGFW")):
        await driver.say("order", id=number, label=label)
    await driver.wheel("release")
    await w.supervisor.heard("RSTP")


@pytest.mark.world(TOKENS)
async def test_seized_by_a_teacher_only(w: World) -> None:
    pupil, other, teacher = await w.pupil(), await w.pupil(), await w.teacher()
    assert pupil.welcome["role"] == "viewer"
    assert teacher.welcome["role"] == "teacher"
    await pupil.wheel("take")
    await w.start_robot(pupil)
    await other.wheel("seize")
    await other.settle()
    assert w.service.hub.state["driver"] == pupil.number
    await teacher.wheel("seize")
    await pupil.event("wheel_seized", **{"from": "#1", "name": "#3"})
    await pupil.state(driver=teacher.number)
    await stops(w, 1)


async def test_nobody_seizes_without_tokens(w: World) -> None:
    await w.driver()
    other = await w.page()
    await other.wheel("seize")
    await other.settle()
    assert w.service.hub.state["driver"] == 1


async def test_a_silent_driver(w: World) -> None:
    _, other = await w.started()
    w.pass_time(hub.SILENCE - 0.01)
    await other.settle()
    assert w.supervisor.count("RSTP") == 0
    w.pass_time(0.02)
    await other.event("stopped_silent", name="#1")
    await stops(w, 1)
    w.pass_time(hub.ABSENCE - hub.SILENCE - 0.02)
    assert w.service.hub.state["driver"] == 1
    w.pass_time(0.02)
    await other.event("wheel_lost", name="#1")
    await other.state(driver=None)


async def test_a_driver_that_is_silent_for_a_moment(w: World) -> None:
    driver, other = await w.started()
    for _ in range(2):
        w.pass_time(hub.SILENCE + 0.1)
        await other.event("stopped_silent")
        await driver.settle()
        assert w.service.hub.state["driver"] == 1
    await w.supervisor.heard("RSTP", 2)


async def test_a_hidden_page(w: World) -> None:
    driver, other = await w.started()
    await driver.say("ping", n=1, hidden=True)
    await other.event("wheel_released", name="#1")
    await other.state(driver=None)
    await stops(w, 1)


async def test_a_closed_tab(w: World) -> None:
    driver, other = await w.started()
    await other.wheel("ask")
    await driver.close()
    await other.event("wheel_lost", name="#1")
    await other.state(driver=None)
    await stops(w, 1)
    assert w.service.hub.state["asking"] == [2]
    await other.wheel("take")
    await other.state(driver=2, asking=[])


async def test_a_cut_connection(w: World) -> None:
    """Without a word of farewell."""
    driver, other = await w.started()
    transport = driver.ws.get_extra_info("socket")
    assert transport is not None
    connection = driver.ws._response.connection
    assert connection is not None and connection.transport is not None
    connection.transport.abort()
    await other.event("wheel_lost", name="#1")
    await stops(w, 1)


async def test_a_wish_ends_with_its_viewer(w: World) -> None:
    driver, other = await w.driver(), await w.page()
    await other.wheel("ask")
    await driver.state(asking=[2])
    await other.close()
    await driver.state(asking=[])


@pytest.mark.world(TOKENS, supervisor_token="secret-of-teacher")
async def test_tokens_are_not_logged(
    w: World, caplog: pytest.LogCaptureFixture
) -> None:
    await w.client().post(f"{w.url}/login", data={"token": "wrong-secret"})
    await w.pupil()
    assert "login refused" in caplog.text
    assert "secret" not in caplog.text
