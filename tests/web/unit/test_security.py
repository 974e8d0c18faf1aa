#  SPDX-License-Identifier: GPL-3.0-or-later
"""Who gets in, and what is refused."""

import pytest
from destijl_web import hub, logins
from destijl_web.origins import Origins, address_to_open
from helpers import LIMIT, TOKENS, World


async def test_headers(w: World) -> None:
    for path in ("/", "/page/none.js", "/recordings", "/nothing"):
        async with w.client().get(w.url + path) as answer:
            policy = answer.headers["Content-Security-Policy"]
            assert policy.startswith("default-src 'none';")
            assert "unsafe" not in policy and "*" not in policy
            for part in ("base-uri 'none'", "frame-ancestors 'none'"):
                assert part in policy
            assert answer.headers["X-Content-Type-Options"] == "nosniff"
            assert answer.headers["Referrer-Policy"] == "same-origin"
            assert answer.headers["Cache-Control"] in ("no-store", "no-cache")
            assert "Server" not in answer.headers


@pytest.mark.world(origins=("https://robot.example",))
async def test_hosts(w: World) -> None:
    port = w.service.port
    for host in (f"127.0.0.1:{port}", f"LOCALHOST:{port}", "robot.example"):
        assert await w.status("/recordings", Host=host) == 404
    for host in (
        "127.0.0.1",
        f"evil.example:{port}",
        f"127.0.0.1.evil.example:{port}",
        f"127.0.0.1:{port + 1}",
        "robot.example:81",
        "",
    ):
        assert await w.status("/recordings", Host=host) == 421


@pytest.mark.world(origins=("https://robot.example",))
async def test_origins(w: World) -> None:
    port = w.service.port
    client = w.client()
    for host, origin in (
        (f"127.0.0.1:{port}", f"http://127.0.0.1:{port}"),
        (f"localhost:{port}", f"http://localhost:{port}"),
        ("robot.example", "https://robot.example"),
        (f"127.0.0.1:{port}", "https://robot.example"),
    ):
        async with client.ws_connect(
            f"{w.url}/ws", origin=origin, headers={"Host": host}
        ):
            pass
    wrong: list[str | None] = [
        None,
        "null",
        "http://evil.example",
        f"https://127.0.0.1:{port}",
        "http://127.0.0.1",
        "http://robot.example",
    ]
    for forged in wrong:
        assert await w.refused(client, forged) == 403


def test_names_of_other_interfaces() -> None:
    origins = Origins("0.0.0.0", 8080, ())
    assert origins.is_host("192.0.2.5:8080", "192.0.2.5")
    assert not origins.is_host("192.0.2.6:8080", "192.0.2.5")
    assert not origins.is_host("192.0.2.5", "192.0.2.5")
    assert origins.is_host("[2001:db8::5]:8080", "2001:db8::5")
    assert Origins("0.0.0.0", 80, ()).is_host("192.0.2.5", "192.0.2.5")
    assert address_to_open("127.0.0.1", 8080) == "http://127.0.0.1:8080/"
    assert address_to_open("::1", 8080) == "http://[::1]:8080/"
    assert "0.0.0.0" not in address_to_open("0.0.0.0", 8080)


@pytest.mark.world(TOKENS)
async def test_nobody_without_a_token(w: World) -> None:
    client = w.client()
    for path in (
        "/recordings",
        "/recordings/20261123T120000.123Z/events.jsonl",
        "/recordings/20261123T120000.123Z/positions.csv",
    ):
        assert await w.status(path) == 401
    for cookie in ("", "made-up", "secret-of-teacher"):
        forged = f"destijl_web_{w.service.port}={cookie}"
        assert await w.refused(client, Cookie=forged) == 401


@pytest.mark.world(TOKENS, origins=("https://robot.example",))
async def test_login(w: World) -> None:
    answer = await w.log_in("secret-of-teacher")
    assert (answer.status, answer.headers["Location"]) == (303, "/")
    cookie = answer.headers["Set-Cookie"]
    for part in ("HttpOnly", "SameSite=Strict", "Path=/"):
        assert part in cookie
    assert "Secure" not in cookie and "secret" not in cookie
    proxied = {"Host": "robot.example", "Origin": "https://robot.example"}
    answer = await w.log_in("secret-of-viewers", **proxied)
    assert "Secure" in answer.headers["Set-Cookie"]
    answer = await w.log_in("secret-of-teache")
    assert answer.headers["Location"] == "/?failed=1"
    assert "Set-Cookie" not in answer.headers
    for origin in ("null", "http://evil.example"):
        assert (await w.log_in("secret-of-teacher", Origin=origin)).status == 403
    answer = await w.log_in("x" * 10_000)
    assert answer.status == 413


@pytest.mark.world(TOKENS, origins=("https://robot.example", "http://other.example"))
async def test_what_has_tls_is_not_reached_without(w: World) -> None:
    proxied = {"Host": "robot.example", "Origin": "http://robot.example"}
    assert (await w.log_in("secret-of-teacher", **proxied)).status == 403
    answer = await w.log_in("secret-of-teacher", Host="robot.example")
    assert "Secure" in answer.headers["Set-Cookie"]
    proxied = {"Host": "other.example", "Origin": "http://other.example"}
    answer = await w.log_in("secret-of-teacher", **proxied)
    assert "Secure" not in answer.headers["Set-Cookie"]


@pytest.mark.world(TOKENS)
async def test_logout(w: World) -> None:
    client = await w.logged_in("secret-of-teacher")
    page, other = await w.page(client), await w.teacher()
    for origin in (None, "http://evil.example"):
        headers = {} if origin is None else {"Origin": origin}
        async with client.post(f"{w.url}/logout", headers=headers) as answer:
            assert answer.status == 403
    await page.settle()
    async with client.post(
        f"{w.url}/logout", headers={"Origin": w.url}, allow_redirects=False
    ) as answer:
        assert (answer.status, answer.headers["Location"]) == (303, "/")
    assert await page.closed() == hub.SESSION_OVER
    assert await w.refused(client) == 401
    await other.settle()


@pytest.mark.world(TOKENS)
async def test_an_open_page_of_a_session_that_is_over(w: World) -> None:
    page = await w.pupil()
    await page.wheel("take")
    await page.state(driver=page.number)
    w.pass_time(logins.LIFE + LIMIT)
    #  silent as its clock stands still, it has lost the wheel before
    assert await page.closed() == hub.SESSION_OVER
    assert w.service.hub.state["driver"] is None
    assert w.service.hub.viewers == {}


DIRECT = pytest.mark.world(TOKENS)
PROXIED = pytest.mark.world(TOKENS, origins=("https://robot.example",))


@pytest.mark.usefixtures("no_recovery")
@pytest.mark.parametrize(
    ("forwarded", "other"),
    [
        pytest.param("", "", marks=DIRECT),
        #  X-Forwarded-For counts behind a proxy only: there its last address, and
        #  all that is no address is one
        pytest.param("192.0.2.{}", "", marks=DIRECT),
        pytest.param("10.0.0.{}, 192.0.2.1", "192.0.2.1, 192.0.2.2", marks=PROXIED),
        pytest.param("<guess {}>", "192.0.2.2", marks=PROXIED),
    ],
)
async def test_login_attempts(w: World, forwarded: str, other: str) -> None:
    headers = {"Host": "robot.example"} if other else {}

    async def log_in(token: str, forwarded: str) -> str:
        if forwarded:
            headers["X-Forwarded-For"] = forwarded
        answer = await w.log_in(token, **headers)
        assert ("Set-Cookie" in answer.headers) == (token != "wrong")
        return answer.headers["Location"]

    for number in range(logins.ATTEMPTS + 1):
        last = await log_in("wrong", forwarded.format(number))
        assert last == "/?failed=" + ("1" if number < logins.ATTEMPTS else "wait")
    #  but nobody's wrong tokens lock out who has the right one
    assert await log_in(TOKENS["token"], "") == "/"
    if other:
        assert await log_in("wrong", other) == "/?failed=1"


@pytest.mark.parametrize(
    "path",
    [
        "/page/",
        "/page/../destijl_web/server.py",
        "/page/..%2fdestijl_web%2fserver.py",
        "/page/%2e%2e/README.md",
        "/page//etc/passwd",
        "/page/.htaccess",
        "/page/index.html%00.js",
        "/page/README.md",
        "/destijl_web/server.py",
    ],
)
async def test_no_other_files(w: World, path: str) -> None:
    """As it is: a client would shorten it."""
    answer = await w.raw([w.request(f"GET {path}") + b"\r\n"])
    assert answer.split()[1] in (b"404", b"400")


async def join(w: World, token: str, path: str = "/join.svg") -> tuple[int, str]:
    async with (await w.logged_in(token)).get(w.url + path) as answer:
        return answer.status, await answer.text()


@pytest.mark.world(token="secret+of+teacher", viewers_token="secret+of+viewers")
async def test_join(w: World) -> None:
    """A teacher alone is given the code; the class's token only if asked for."""
    assert await w.status("/join.svg?token") == 401
    assert (await join(w, "secret+of+viewers", "/join.svg?token"))[0] == 403
    for path, fragment in (
        ("/join.svg", ""),
        ("/join.svg?token", "#token=secret%2Bof%2Bviewers"),
    ):
        code, svg = await join(w, "secret+of+teacher", path)
        assert code == 200
        assert f"<title>{w.url}/{fragment}</title>" in svg


@pytest.mark.world(token="secret-of-teacher")
async def test_join_without_a_token_of_the_class(w: World) -> None:
    assert f"<title>{w.url}/</title>" in (await join(w, "secret-of-teacher"))[1]
    _, svg = await join(w, "secret-of-teacher", "/join.svg?token")
    assert f"<title>{w.url}/</title>" in svg


async def test_join_without_tokens(w: World) -> None:
    assert await w.status("/join.svg") == 403


def test_address_for_others() -> None:
    """As the teacher came, but not this machine's own name for itself."""
    everywhere = Origins("192.0.2.5", 8080, ())
    assert everywhere.for_others("robot.local:8080") == "http://robot.local:8080/"
    for own in ("localhost:8080", "127.0.0.1:8080", "[::1]:8080"):
        assert everywhere.for_others(own) == "http://192.0.2.5:8080/"
    proxied = Origins("127.0.0.1", 8080, ("https://robot.example", "http://b.example"))
    for host in ("b.example", "127.0.0.1:8080"):
        assert proxied.for_others(host) == "https://robot.example/"
