#  SPDX-License-Identifier: GPL-3.0-or-later
"""What script/machine tries, in this order: each a function of the target,
which raises Wrong with what does not hold."""

from __future__ import annotations

import re
import shutil
import subprocess
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

from targets import ROOT, SLACK, Board, Machine, Wrong

STOP = 5.0
#  F5: seconds after which a robot without a monitor stands
WATCHDOG = 3.6
#  Likewise one without a supervisor: three reloads missed
BY_ID = "/dev/serial/by-id/usb-QEMU_QEMU_USB_SERIAL_robot-if00-port0"
SETTINGS = "/etc/default/destijl"
WAITS = "--answer-timeout 300"
#  Processors that are emulated answer late

Act = TypeVar("Act", bound=Callable[..., None])


@dataclass
class Scenario:
    name: str
    short: bool
    on_board: Callable[..., None] | None
    on_machine: Callable[..., None] | None


scenarios: list[Scenario] = []


def scenario(
    name: str, short: bool = False, boards: bool = False, machines: bool = True
) -> Callable[[Act], Act]:
    """What is tried on emulated machines, on boards, or on both."""

    def add(act: Act) -> Act:
        scenarios.append(
            Scenario(name, short, act if boards else None, act if machines else None)
        )
        return act

    return add


def serve(board: Board, line: str = "", options: str = "") -> None:
    """The service runs; of a board with the settings that it has."""
    if isinstance(board, Machine):
        board.robot = board.usb if line else board.wire
        camera = f"--camera http://10.0.3.2:{board.wire.camera}/stream.mjpg"
        board.start(
            DESTIJL_SERIAL=line or board.line,
            DESTIJL_OPTIONS=f"{WAITS} {options or camera}",
        )
    else:
        board.run("systemctl start destijl")


def matches(pattern: str, text: str) -> None:
    if not re.search(pattern, text, re.MULTILINE):
        raise Wrong(f"{pattern!r} is not in: {text}")


def moving(board: Board) -> None:
    if board.robot:
        board.robot.await_moving(True, 10.0)


def stands(board: Board, limit: float, since: float = 0.0) -> None:
    """Five seconds are told from fifteen. Since: a mark, of which on the machine
    itself may have stood still."""
    if board.robot:
        took = board.robot.await_moving(False, 30.0)
        if took > limit + SLACK and (
            not since or took > limit + SLACK + board.stood_still(since)
        ):
            raise Wrong(f"the robot stands after {took:.1f} s, not {limit:.1f}")


def put(machine: Machine, packages: list[Path], folder: str) -> None:
    files = [path.name for path in packages]
    archive = subprocess.run(
        ["tar", "-C", packages[0].parent, "-c", *files], capture_output=True, check=True
    )
    subprocess.run(
        [*machine.ssh, machine.target, f"mkdir -p {folder} && tar -x -C {folder}"],
        input=archive.stdout,
        check=True,
    )


def install_packages(machine: Machine, files: str) -> None:
    machine.run(
        "DEBIAN_FRONTEND=noninteractive apt-get -qq install --no-install-recommends"
        f" --reinstall -y {files}",
        900.0,
    )


def whole_token(machine: Machine) -> None:
    found = machine.run("stat -c '%a %U %s' /etc/destijl/token")
    if found != "600 root 33":
        raise Wrong(f"the token after it: {found}")


@scenario("installed, and the power cut within a second", short=True)
def install(machine: Machine) -> None:
    put(machine, sorted(machine.packages.glob("destijl*.deb")), "/root/packages")
    install_packages(machine, "/root/packages/*.deb")
    machine.power_cut()
    machine.power_on()
    whole_token(machine)
    machine.run(
        'test -z "$(dpkg --audit)"; test -s /etc/default/destijl\n'
        "systemctl -q is-enabled destijl; systemctl -q is-enabled destijl-web\n"
        "! systemctl -q is-active destijl destijl-web"
    )
    for program in ("destijl", "destijl_monitor", "destijl_emulator", "destijl_web"):
        package = program.replace("_", "-")
        version = machine.run(f"dpkg-query -W -f '${{Version}}' {package}")
        pattern = rf"{program} {re.escape(version.rsplit('-', 1)[0])}\b"
        matches(pattern, machine.run(f"{program} --version"))
        machine.run(
            f"cd /usr/share; test -s zsh/vendor-completions/_{program}\n"
            f"test -s bash-completion/completions/{program}\n"
            f"dpkg -L {package} | grep -q /man1/{program}.1"
        )
    #  of an older package: named, and made again
    machine.run(f": >/etc/destijl/token; sed -i s/SERIAL=.*/SERIAL=none/ {SETTINGS}")
    since = machine.mark()
    machine.attempt("systemctl start destijl")
    machine.logged("/etc/destijl/token", since)
    machine.run("systemctl stop destijl")
    #  all of them: what systemd's helper has noted for a purge is lost, too
    install_packages(machine, "/root/packages/*.deb")
    whole_token(machine)


@scenario("--check as the service, and its sandbox", short=True, boards=True)
def check(board: Board) -> None:
    serve(board)
    board.run("systemctl stop destijl")
    status, said = board.attempt("/usr/lib/destijl/check-service")
    kernel = "(not )?PREEMPT_RT"
    if isinstance(board, Machine):
        kernel = "PREEMPT_RT" if board.kernel == "rt" else "not PREEMPT_RT"
    for fact in (
        "real-time priorities: FIFO, ceilings",
        "memory: [0-9]+ MB, can be locked",
        rf"kernel [0-9]\S+: {kernel}$",
        "serial line /dev/.*: opens",
        "camera: delivers images",
        "token file /run/credentials/.*: holds a token",
    ):
        matches("^ok      " + fact, said)
    if status != 0:
        raise Wrong(f"status {status}: {said}")
    serve(board)
    said = board.run("journalctl -b -u destijl -o cat -n 20")
    matches("real-time priorities: FIFO, ceilings; memory: locked; deadlines:", said)
    said = board.run("cat /proc/$(systemctl show --value -p MainPID destijl)/status")
    matches("^CapEff:\t0000000000800000$", said)
    matches("^CapBnd:\t0000000000800000$", said)
    matches("^NoNewPrivs:\t1$", said)
    matches("^Seccomp:\t2$", said)
    matches("^Uid:\t[1-9]", said)
    board.run("systemd-analyze --no-pager security --threshold=20 destijl")


@scenario("a whole session", short=True, boards=True)
def session(board: Board, line: str = "", options: str = "") -> None:
    serve(board, line, options)
    use(board, line, options)


def use(board: Board, line: str = "", options: str = "") -> None:
    """A session with the service that runs."""
    with board.monitor() as monitor:
        monitor.demand("ROPN", "RSWW", "RGLF", "RSTP", "RMOV:100", "RTRN:90")
        monitor.ask("RGBT", "RBLV:[012]")
        #  loads OpenCV
        monitor.demand("COPN")
        monitor.ask("", "CIMG:")
        if isinstance(board, Machine) and not options:
            monitor.ask("CASA", "CIMG:")
            monitor.tell("CACO")
            monitor.demand("CPCO")
            monitor.ask("", "CPOS:[0-9]")
        monitor.demand("CCLS", "RCLS")
    if isinstance(board, Machine) and not line:
        number = board.line[-1]
        matches(
            f"{number}: uart:16550A .*tx:[1-9]",
            board.run("cat /proc/tty/driver/serial"),
        )
        matches("^9600$", board.run(f"stty -F {board.line} speed"))


@scenario("USB: late driver, unplugged while driving, another name", short=True)
def usb(machine: Machine) -> None:
    serve(machine, BY_ID)
    with machine.monitor() as monitor:
        if monitor.ask("ROPN") != "ANAK":
            raise Wrong("a line that is not there opens")
        machine.plug("usb", "robot")
        machine.expect(f"test -e {BY_ID}")
        monitor.drive()
        moving(machine)
        since = machine.mark()
        machine.unplug("robot")
        monitor.ask("", "ATIM")
        machine.logged("robot lost: the device of its line has gone", since)
        stands(machine, WATCHDOG)
        machine.plug("other", "other")
        machine.expect("test -e /dev/ttyUSB0")
        machine.plug("usb", "robot")
        machine.expect(f"test $(realpath {BY_ID}) = /dev/ttyUSB1")
        monitor.demand("ROPN", "RRST")
        monitor.drive()
        moving(machine)
    stands(machine, 1.0)
    session(machine, BY_ID)
    machine.unplug("robot")
    machine.unplug("other")


CUTS = {
    "own interface down": (
        "ip link set $dev down",
        "ip link set $dev up; ip address replace $own dev $dev",
        "cannot be reached|vanished",
    ),
    "own address gone": (
        "ip address del $own dev $dev",
        "ip address replace $own dev $dev",
        "cannot be reached|vanished",
    ),
    "own route gone": (
        "ip route del ${own%.*}.0/24 dev $dev",
        "ip route replace ${own%.*}.0/24 dev $dev src ${own%/*}",
        "cannot be reached|vanished",
    ),
    "packets to the monitor dropped": (
        "nft add table netdev cut; nft add chain netdev cut out"
        " '{ type filter hook egress device '$dev' priority 0; }';"
        " nft add rule netdev cut out tcp sport 5544 drop",
        "nft delete table netdev cut",
        "cannot be reached|vanished",
    ),
    "packets from the monitor dropped": (
        "nft add table netdev cut; nft add chain netdev cut in"
        " '{ type filter hook ingress device '$dev' priority 0; }';"
        " nft add rule netdev cut in tcp dport 5544 drop",
        "nft delete table netdev cut",
        "vanished",
    ),
    "carrier gone": ("card", "card", "cannot be reached|vanished"),
    "peer gone": ("far", "far", "vanished"),
}
ON_BOARDS = ("own interface down", "packets to", "packets from")


def cut(board: Board, name: str) -> None:
    begin, end, why = CUTS[name]
    serve(board)
    with board.monitor() as monitor:
        monitor.drive()
        moving(board)
        since = board.mark()
        if isinstance(board, Machine) and " " not in begin:
            board.qmp("set_link", name=begin, up=False)
        else:
            peer = "10.0.2.2" if isinstance(board, Machine) else "$PEER"
            board.run(
                f"peer={peer}\n"
                "dev=$(ip -o route get $peer | sed 's/.* dev \\([^ ]*\\).*/\\1/')\n"
                "own=$(ip -o -4 address show dev $dev | awk '{ print $4; exit }')\n"
                "export dev own; touch /run/cut\n"
                "setsid sh -c \"$(cat <<'END'\n"
                f'{begin}; sleep 12; {end}; rm /run/cut\nEND\n)" >/dev/null 2>&1 &'
            )
        try:
            stands(board, STOP, since)
        finally:
            if isinstance(board, Machine) and " " not in begin:
                board.qmp("set_link", name=end, up=True)
        board.expect("test ! -e /run/cut", 60.0)
        lost = board.logged(f"monitor lost: .*({why})", since)
        if lost > STOP + SLACK + board.stood_still(since):
            raise Wrong(f"the loss is found after {lost:.1f} s")
    with board.monitor() as monitor:
        monitor.demand("ROPN", "RCLS")


for name in CUTS:
    scenario(f"network: {name}", True, boards=name.startswith(ON_BOARDS))(
        partial(cut, name=name)
    )


@scenario("power cut while driving", short=True)
def power(machine: Machine) -> None:
    serve(machine)
    with machine.monitor() as monitor:
        monitor.drive()
        moving(machine)
        machine.mark()
        machine.power_cut()
        stands(machine, WATCHDOG)
    machine.power_on()
    machine.expect("journalctl -b -u destijl | grep 'was sent a stop'")
    machine.run("journalctl -b -1 -u destijl | grep 'listening on'")
    with machine.monitor() as monitor:
        monitor.drive()
        moving(machine)


def browse(machine: Machine) -> subprocess.Popen[str]:
    """A browser that drives, as long as it lives."""
    token = machine.place / "token"
    token.touch(0o600)
    token.write_text(machine.run("head -n 1 /etc/destijl/token") + "\n")
    browser = subprocess.Popen(
        [ROOT / "script/systemd/browse", f"http://127.0.0.1:{machine.web_port}", token],
        stdout=subprocess.PIPE,
        stderr=(machine.place / "browse.log").open("w"),
        text=True,
    )
    assert browser.stdout
    for line in browser.stdout:
        if line.startswith("an image"):
            return browser
    raise Wrong("no image for a browser: " + (machine.place / "browse.log").read_text())


def serve_browsers(machine: Machine, supervisor: str = "127.0.0.1:5544") -> None:
    """None if there is no supervisor."""
    options = f"--bind 0.0.0.0 --origin http://127.0.0.1:{machine.web_port}"
    machine.run(
        f"sed -i -e 's|SUPERVISOR=.*|SUPERVISOR={supervisor}|' -e"
        f" 's|OPTIONS=.*|OPTIONS={options} --record /var/lib/destijl-web|'"
        " /etc/default/destijl-web; systemctl restart destijl-web"
    )


@scenario("reboot while a browser drives: trace and recording are there")
def reboot(machine: Machine) -> None:
    machine.run(
        "mkdir -p /etc/systemd/system/destijl.service.d\n"
        "printf '[Service]\\nStateDirectory=destijl\\n'"
        " >/etc/systemd/system/destijl.service.d/trace.conf; systemctl daemon-reload"
    )
    serve(machine)
    machine.run(
        f"sed -i '/^DESTIJL_OPTIONS/s|$| --trace /var/lib/destijl/trace|' {SETTINGS}"
    )
    machine.run("systemctl restart destijl")
    serve_browsers(machine)
    browser = browse(machine)
    try:
        moving(machine)
        machine.attempt("systemctl --no-block reboot")
        stands(machine, STOP)
        machine.rebooted()
    finally:
        browser.kill()
        browser.wait()
    machine.expect("systemctl -q is-active destijl destijl-web")
    trace = machine.place / "trace"
    trace.write_text(machine.run("cat /var/lib/private/destijl/trace"))
    subprocess.run(
        [ROOT / "script/trace", trace], stdout=subprocess.DEVNULL, check=True
    )
    machine.run(
        "find /var/lib/private/destijl-web -name images.mjpeg -size +0 | grep ."
    )
    serve_browsers(machine, "")
    machine.run(
        "systemctl stop destijl\n"
        "rm -r /etc/systemd/system/destijl.service.d; systemctl daemon-reload\n"
        "rm -r /var/lib/destijl /var/lib/private/destijl"
    )


@scenario("root read-only, and the power cut, while a browser drives")
def read_only(machine: Machine) -> None:
    serve(machine)
    serve_browsers(machine)
    browser = browse(machine)
    try:
        moving(machine)
        machine.run("echo u >/proc/sysrq-trigger")
        machine.expect("! touch /root/written")
        time.sleep(STOP)
        if browser.poll() is not None or machine.wire.status()["moving"] != "1":
            raise Wrong("the session ends with the disk")
        #  the next one cannot be recorded
        browser.kill()
        browser.wait()
        restarts = "systemctl show --value -p NRestarts destijl-web"
        before = machine.run(restarts)
        machine.run("systemctl restart destijl")
        browser = browse(machine)
        moving(machine)
        if machine.run(restarts) != before:
            raise Wrong("the gateway ends with the disk")
        machine.power_cut()
        stands(machine, WATCHDOG)
    finally:
        browser.kill()
        browser.wait()
        #  else the next scenarios would have that disk, too
        machine.power_cut()
    machine.power_on()
    machine.expect("systemctl -q is-active destijl destijl-web")
    machine.run("ls /var/lib/private/destijl-web/*/images.mjpeg")
    serve_browsers(machine, "")


@scenario("a getty on the line, a console")
def getty(machine: Machine) -> None:
    tty = machine.kind.line
    unit = f"serial-getty@{tty}"
    has = f"systemctl start {unit}; ps -o tty= -C agetty | grep -x {tty}"
    for line, begun, fact in (
        (machine.line, has, "has it as its terminal"),
        ("/dev/" + machine.kind.console, "true", "it is a console of the kernel"),
    ):
        machine.start(DESTIJL_SERIAL=line)
        machine.run("systemctl stop destijl")
        machine.expect(begun)
        _, said = machine.attempt("/usr/lib/destijl/check-service")
        #  it leaves the line to the group tty, until the next boot
        machine.run(
            f"systemctl stop {unit}; chgrp dialout {machine.line};"
            f" chmod 660 {machine.line}"
        )
        matches(f"^not ok  serial line {line}: .*{fact}", said)


@scenario("a camera of the kernel, its driver late, unplugged, its metadata")
def vivid(machine: Machine) -> None:
    machine.run("! lsmod | grep -q ^vivid || modprobe -r vivid")
    serve(machine, options="--camera /dev/video0")
    with machine.monitor() as monitor:
        if monitor.ask("COPN") != "ANAK":
            raise Wrong("a camera that is not there opens")
        machine.run("modprobe vivid n_devs=1 node_types=0x20001")
        machine.expect("test -c /dev/video1 && udevadm settle")
        monitor.demand("COPN")
        monitor.ask("", "CIMG:")
        since = machine.mark()
        machine.run("echo vivid.0 >/sys/bus/platform/drivers/vivid/unbind")
        monitor.ask("", "MSSG:camera closed")
        machine.logged("camera closed: it delivers", since)
        machine.run("echo vivid.0 >/sys/bus/platform/drivers/vivid/bind")
        machine.expect("test -c /dev/video0 && udevadm settle")
        monitor.demand("COPN")
        monitor.ask("", "CIMG:")
    for options, fact in (
        ("0 --frame-size 1280x720", "^ok      camera: delivers images, .* 1280x720"),
        ("0 --frame-size 640x360", "^ok      camera: delivers images, .* 640x360"),
        ("1", "^not ok  camera .*metadata"),
    ):
        serve(machine, options=f"--camera {options}")
        machine.run("systemctl stop destijl")
        _, said = machine.attempt("/usr/lib/destijl/check-service")
        matches(fact, said)
    session(machine, options="--camera 0")
    machine.run("systemctl stop destijl; modprobe -r vivid")


@scenario("a full disk")
def full(machine: Machine) -> None:
    serve(machine)
    try:
        machine.run(
            "dd if=/dev/zero of=/full bs=1M 2>/dev/null || true\n"
            "! dd if=/dev/zero of=/full2 bs=4k count=64 2>/dev/null"
        )
        use(machine)
        machine.run("systemctl restart destijl")
        with machine.monitor() as monitor:
            monitor.drive()
            moving(machine)
        stands(machine, 1.0)
    finally:
        machine.run("rm -f /full /full2")


@scenario("clock set forward and back while driving", boards=True)
def clock(board: Board) -> None:
    serve(board)
    with board.monitor() as monitor:
        monitor.drive()
        for jump in ("1 day", "2 days ago", "1 day"):
            board.run(f"date -s '{jump}' >/dev/null")
            time.sleep(2.0)
            monitor.demand("RPIN")
            moving(board)
        monitor.demand("RSTP")


@scenario("the supervisor stopped by SIGSTOP while driving", boards=True)
def stop_signal(board: Board) -> None:
    serve(board)
    with board.monitor() as monitor:
        monitor.drive()
        moving(board)
        board.run("systemctl kill -s STOP destijl")
        stands(board, WATCHDOG)
        time.sleep(0.0 if board.robot else WATCHDOG)
        board.run("systemctl kill -s CONT destijl")
    with board.monitor() as monitor:
        monitor.demand("ROPN", "RRST")
        monitor.drive()
        moving(board)
    stands(board, 1.0)


@scenario("rebooted while driving", boards=True, machines=False)
def reboot_driving(board: Board) -> None:
    serve(board)
    with board.monitor() as monitor:
        monitor.drive()
        moving(board)
        board.attempt("systemctl --no-block reboot")
        stands(board, STOP)
    board.rebooted()
    board.expect("systemctl -q is-active destijl", 60.0)
    with board.monitor() as monitor:
        monitor.drive()


@scenario("debian/tests: both services, and each of their ways to end")
def ended(machine: Machine) -> None:
    machine.run("systemctl stop destijl-web destijl")
    put(machine, [ROOT / "debian", ROOT / "script"], "/root/source")
    machine.run(
        "rm -rf /root/trial; mkdir /root/trial; cd /root/source\n"
        "export AUTOPKGTEST_TMP=/root/trial PATIENCE=10\n"
        "debian/tests/drive >/root/said || { grep -v systemd /root/said; false; }",
        900.0,
    )


@scenario("upgraded while driving")
def upgrade(machine: Machine) -> None:
    serve(machine)
    package = next(machine.packages.glob("destijl_*.deb"))
    tree = machine.place / "next"
    made = machine.place / package.name
    subprocess.run(["dpkg-deb", "-R", package, tree], check=True)
    control = tree / "DEBIAN/control"
    control.write_text(re.sub("(?m)^(Version: .*)$", r"\1.1", control.read_text()))
    subprocess.run(
        ["dpkg-deb", "--root-owner-group", "-Zgzip", "-z1", "-b", tree, made],
        stdout=subprocess.DEVNULL,
        check=True,
    )
    shutil.rmtree(tree)
    put(machine, [made], "/root/next")
    known = "sha256sum /etc/destijl/token " + SETTINGS
    before = machine.run(known)
    with machine.monitor() as monitor:
        monitor.drive()
        moving(machine)
        since = machine.mark()
        install_packages(machine, "/root/next/*.deb")
        stands(machine, 0.0)
    machine.logged("listening on", since)
    if machine.run(known) != before:
        raise Wrong("token or settings are others")
    with machine.monitor() as monitor:
        monitor.drive()
        moving(machine)


@scenario("removed, installed again, purged")
def purge(machine: Machine) -> None:
    packages = "destijl destijl-web destijl-monitor destijl-emulator"
    known = (
        "sha256sum /etc/destijl/token /etc/default/destijl*\n"
        "find /var/lib/private/destijl-web -name images.mjpeg | sort"
    )
    before = set(machine.run(known).splitlines())
    machine.run(f"apt-get -qq remove -y {packages}; test ! -e /usr/bin/destijl")
    machine.run("! systemctl -q is-active destijl destijl-web")
    install_packages(machine, "/root/packages/*.deb")
    if not before <= set(machine.run(known).splitlines()):
        raise Wrong("token, settings or recordings are others")
    machine.run(f"apt-get -qq purge -y {packages}")
    left = machine.run(
        "find / -xdev -name '*destijl*' ! -path '/root/*' ! -path '/var/log/*'"
        " ! -path '/var/cache/*' ! -path '/proc/*' ! -path '/sys/*' ! -path '/tmp/*'"
    )
    if left:
        raise Wrong(f"it leaves {left}")
    machine.run("! { systemctl cat destijl || getent passwd destijl; }")
