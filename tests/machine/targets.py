#  SPDX-License-Identifier: GPL-3.0-or-later
"""What script/machine tries the supervisor on: a board, reached by ssh, or a
machine that is emulated by qemu, with emulated robots on its serial lines."""

from __future__ import annotations

import json
import re
import shlex
import socket
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ANSWER = "AACK|ANAK|ACRJ|ACER|ATIM"
SLACK = 3.0
#  Seconds of an answer's way through an emulator, ssh and a log


AS_ROOT = (
    "export PEER=${SSH_CONNECTION%% *};"
    ' test "$(id -u)" = 0 || as="sudo -n env PEER=$PEER"; $as sh -s'
)


class Wrong(Exception):
    """What does not hold."""


def words(command: str, **values: object) -> list[str]:
    """The words of a command, in which {name} is that value, whatever is in it."""
    return [word.format(**values) for word in command.split()]


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return int(one.getsockname()[1])


class Monitor:
    """A monitor that announces no signs of life, as the existing one."""

    def __init__(self, host: str, port: int, token: str, seconds: float = 60.0) -> None:
        ends = time.monotonic() + seconds
        while True:
            try:
                self.socket = socket.create_connection((host, port), 10.0)
                self.input = self.socket.makefile("r", encoding="latin-1", newline="\n")
                self.socket.sendall(f"AUTH:{token}\n".encode())
                self.ask("RCLS", seconds=10.0)
                return
            except (OSError, Wrong) as problem:
                if time.monotonic() > ends:
                    raise Wrong(f"no monitor is admitted: {problem}") from problem
                time.sleep(0.5)

    def __enter__(self) -> Monitor:
        return self

    def __exit__(self, *_: object) -> None:
        self.input.close()
        self.socket.close()

    def tell(self, order: str) -> None:
        self.socket.sendall(order.encode() + b"\n")

    def ask(self, order: str, answer: str = ANSWER, seconds: float = 120.0) -> str:
        """The next line that is an answer; without an order what comes."""
        if order:
            self.tell(order)
        ends = time.monotonic() + seconds
        while (left := ends - time.monotonic()) > 0:
            self.socket.settimeout(left)
            try:
                line = self.input.readline()
            except OSError as problem:
                raise Wrong(f"no {answer} of the supervisor: {problem}") from problem
            if not line:
                raise Wrong(f"the supervisor closes the connection, no {answer}")
            if re.match(answer, line):
                return line.strip()
        raise Wrong(f"no {answer} within {seconds:.0f} s")

    def demand(self, *orders: str) -> None:
        for order in orders:
            for _ in range(50):
                answer = self.ask(order)
                if answer != "ACRJ":
                    break
                time.sleep(0.2)
            if answer != "AACK":
                raise Wrong(f"{order} is answered {answer}")

    def drive(self) -> None:
        self.demand("ROPN", "RSWW", "RGLF")


class Robot:
    """An emulated robot on a pseudo-terminal of this machine, with a camera."""

    def __init__(self, folder: Path, name: str) -> None:
        self.process = subprocess.Popen(
            words(
                "{root}/bin/destijl_emulator --camera-port 0 --camera-fps 5"
                " --boot-ms 0 --stay-on",
                root=ROOT,
            ),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=(folder / f"{name}.log").open("w"),
            text=True,
        )
        self.device = self.line("device ").split()[1]
        self.camera = int(re.findall(r":(\d+)/", self.line("camera "))[0])

    def line(self, start: str) -> str:
        assert self.process.stdout
        for line in self.process.stdout:
            if line.startswith(start):
                return line
        raise Wrong("the emulated robot has ended")

    def status(self) -> dict[str, str]:
        assert self.process.stdin
        self.process.stdin.write("status\n")
        self.process.stdin.flush()
        return dict(word.split("=", 1) for word in self.line("state=").split())

    def await_moving(self, moving: bool, seconds: float) -> float:
        """After how many seconds it was so."""
        begun = time.monotonic()
        while (self.status()["moving"] == "1") != moving:
            if time.monotonic() - begun > seconds:
                state = "stands" if moving else "drives on"
                raise Wrong(f"the robot {state} after {seconds:.1f} s")
            time.sleep(0.1)
        return time.monotonic() - begun

    def end(self) -> None:
        self.process.kill()
        self.process.wait()


class Board:
    """A machine with the packages installed, reached by ssh."""

    address = ""
    port = 5544
    robot: Robot | None = None

    def __init__(self, target: str, place: Path, *options: str) -> None:
        self.target, self.place = target, place
        self.ssh = ["ssh", "-o", "ControlMaster=auto", "-o", "ControlPersist=yes"]
        self.ssh += ["-o", f"ControlPath={place}/ssh", "-o", "BatchMode=yes"]
        self.ssh += ["-o", "ConnectTimeout=10", *options]
        said = subprocess.run([*self.ssh, "-G", target], capture_output=True, text=True)
        self.address = (
            self.address or re.findall(r"(?m)^hostname (.*)$", said.stdout)[0]
        )

    def end(self) -> None:
        subprocess.run([*self.ssh, "-O", "exit", self.target], capture_output=True)

    def attempt(self, script: str, seconds: float = 300.0) -> tuple[int, str]:
        """The exit status and the output of a script of the shell, as root."""
        try:
            done = subprocess.run(
                [*self.ssh, self.target, AS_ROOT],
                input="{\n" + script + "\n} </dev/null 2>&1\n",
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
                timeout=seconds,
            )
        except subprocess.TimeoutExpired as problem:
            raise Wrong(f"no end within {seconds:.0f} s: {script}") from problem
        return done.returncode, done.stdout.strip()

    def run(self, script: str, seconds: float = 300.0) -> str:
        status, said = self.attempt("set -e\n" + script, seconds)
        if status != 0:
            raise Wrong(f"status {status} of {script!r}: {said[-1500:]}")
        return said

    def expect(self, condition: str, seconds: float = 60.0) -> None:
        """Until the condition holds there."""
        wait = f"until {condition}; do sleep 0.2; done >/dev/null 2>&1"
        status, said = self.attempt(
            f"timeout {seconds} sh -c {shlex.quote(wait)}", seconds + 60.0
        )
        if status != 0:
            raise Wrong(f"not within {seconds:.0f} s: {condition} {said[-500:]}")

    def mark(self) -> float:
        """Seconds since its start; what was logged before is on its disk."""
        return float(self.run("journalctl --sync; cut -d' ' -f1 /proc/uptime"))

    def logged(self, words: str, since: float, seconds: float = 60.0) -> float:
        """Seconds from the mark to the line with the words in the log, both by
        the machine's own monotonic clock."""
        find = (
            "journalctl --sync; journalctl -b -u destijl -o short-monotonic |"
            f" grep -E -- {shlex.quote(words)} | tr -d '[]' |"
            f" awk '$1 >= {since:.2f} {{ print $1; exit }}' | grep ."
        )
        self.expect(find, seconds)
        return float(self.run(find)) - since

    def monitor(self, seconds: float = 60.0) -> Monitor:
        token = self.run("head -n 1 /etc/destijl/token")
        return Monitor(self.address, self.port, token, seconds)

    def stood_still(self, since: float) -> float:
        """Seconds since the mark in which a sleeping process of the machine was
        not woken in time: what a slow host takes, not the supervisor."""
        late = f"awk '$1 > {since} {{ s += $2 }} END {{ print s + 0 }}' /run/late"
        return float(self.run(late))

    def watch(self) -> None:
        beat = """
import time
last = time.monotonic()
while True:
    time.sleep(0.1)
    now = time.monotonic()
    if now - last > 0.3:
        print(now, now - last - 0.1, flush=True)
    last = now
"""
        self.run(
            "systemctl -q is-active late ||"
            " systemd-run -q --unit=late -p StandardOutput=append:/run/late"
            f" /usr/bin/python3 -c {shlex.quote(beat)}; touch /run/late"
        )

    def reached(self, seconds: float = 300.0) -> None:
        """Until it has started."""
        ends = time.monotonic() + seconds
        while True:
            status, said = self.attempt("systemctl is-system-running --wait", 180.0)
            if status != 255 and said in ("running", "degraded"):
                break
            if time.monotonic() > ends or not self.alive():
                raise Wrong(f"it does not start: {said} {self.console()}")
            time.sleep(1.0)
        self.watch()

    def recover(self) -> None:
        self.reached()

    def alive(self) -> bool:
        return True

    def console(self) -> str:
        return ""

    def rebooted(self) -> None:
        self.end()
        time.sleep(10.0)
        self.reached()

    def start(self, **settings: str) -> None:
        """The service, with these settings besides those it has."""
        changes = "".join(
            f"sed -i 's|^{name}=.*|{name}={value}|' /etc/default/destijl\n"
            for name, value in settings.items()
        )
        self.run(changes + "systemctl restart destijl")
        self.expect(
            "journalctl -b -u destijl _PID=$(systemctl show --value"
            " -p MainPID destijl) | grep 'listening on'"
        )


@dataclass
class Kind:
    """An emulated computer."""

    qemu: str
    #  with its console
    wire: str
    console: str
    line: str
    #  The terminals of the console and of the robot's line


KINDS = {
    "amd64": Kind(
        "qemu-system-x86_64 -machine pc -cpu Nehalem -serial chardev:console",
        "-serial chardev:wire",
        "ttyS0",
        "ttyS1",
    ),
    "arm64": Kind(
        "qemu-system-aarch64 -machine virt -cpu cortex-a72 -serial chardev:console",
        "-device pci-serial,chardev=wire",
        "ttyAMA0",
        "ttyS0",
    ),
}


class Machine(Board):
    """An emulated computer with a robot's line; another robot can be plugged in
    by USB; eth0 is for ssh, eth1 has the monitor."""

    address = "127.0.0.1"

    def __init__(
        self,
        kept: Path,
        packages: Path,
        arch: str,
        kernel: str,
        accel: str,
        place: Path,
    ) -> None:
        self.kept, self.packages, self.kernel = kept, packages, kernel
        self.kind, self.accel = KINDS[arch], accel
        self.line = "/dev/" + self.kind.line
        self.port, self.ssh_port, self.web_port = (free_port() for _ in range(3))
        super().__init__(
            "root@127.0.0.1", place, "-F", "none", "-i", str(kept / "key"), "-p",
            str(self.ssh_port), "-o", "StrictHostKeyChecking=no",
            "-o", "UserKnownHostsFile=/dev/null", "-o", "LogLevel=ERROR",
        )  # fmt: skip
        self.qemu: subprocess.Popen[bytes] | None = None
        self.disk = place / "disk"
        subprocess.run(
            words(
                "qemu-img create -q -f qcow2 -F raw -b {kept}/disk {disk}",
                kept=kept,
                disk=self.disk,
            ),
            check=True,
        )
        self.wire, self.usb = Robot(place, "wire"), Robot(place, "usb")
        self.robot = self.wire

    def power_on(self, again: bool = True) -> None:
        """Once more if Linux panics before it has started anything of ours, as it
        does now and then on emulated processors."""
        written = self.place / "console.log"
        before = len(written.read_bytes()) if written.exists() else 0
        self.start_qemu()
        try:
            self.reached()
        except Wrong:
            said = written.read_bytes()[before:].decode(errors="replace")
            if not again or "Kernel panic" not in said or "destijl" in said:
                raise
            print(f"panicked as it started, tried again: {said[-3000:]}", flush=True)
            self.power_cut()
            self.power_on(again=False)

    def start_qemu(self) -> None:
        qmp = self.place / "qmp"
        qmp.unlink(missing_ok=True)
        self.control = socket.socket(socket.AF_UNIX)
        self.said = self.control.makefile("r")
        #  eth1 is behind a hub: its far side can be gone, the carrier there
        self.qemu = subprocess.Popen(
            words(
                f"{self.kind.qemu} {'-cpu host' if self.accel == 'kvm' else ''}"
                " -nodefaults -display none -no-reboot -accel {accel} -smp 2 -m 2048"
                " -kernel {kernel}/vmlinuz -initrd {kernel}/initrd -append"
                " {append} -drive file={disk},if=virtio,cache=writeback"
                " -chardev file,id=console,path={place}/console.log,append=on"
                f" -chardev serial,id=wire,path={{wire}} {self.kind.wire}"
                " -chardev serial,id=usb,path={usb} -chardev null,id=other"
                " -device qemu-xhci"
                " -netdev user,id=ssh,net=10.0.3.0/24,hostfwd={ssh}-10.0.3.15:22"
                " -device virtio-net-pci,netdev=ssh,mac=52:54:00:00:00:01"
                " -netdev user,id=far,hostfwd={port}-10.0.2.15:5544,hostfwd="
                "{web}-10.0.2.15:8080 -netdev hubport,id=far-hub,hubid=1,netdev=far"
                " -netdev hubport,id=near,hubid=1"
                " -device virtio-net-pci,id=card,netdev=near,mac=52:54:00:00:00:02"
                " -qmp unix:{place}/qmp,server=on,wait=off",
                accel=self.accel,
                kernel=self.kept / self.kernel,
                append=f"root=/dev/vda console={self.kind.console} net.ifnames=0"
                " panic=-1 mitigations=off",
                disk=self.disk,
                place=self.place,
                wire=self.wire.device,
                usb=self.usb.device,
                ssh=f"tcp:127.0.0.1:{self.ssh_port}",
                port=f"tcp:127.0.0.1:{self.port}",
                web=f"tcp:127.0.0.1:{self.web_port}",
            ),
            stdin=subprocess.DEVNULL,
            stdout=(self.place / "qemu.log").open("a"),
            stderr=subprocess.STDOUT,
            process_group=0,
        )
        ends = time.monotonic() + 20.0
        while not qmp.exists():
            if self.qemu.poll() is not None or time.monotonic() > ends:
                raise Wrong((self.place / "qemu.log").read_text()[-500:])
            time.sleep(0.05)
        self.control.connect(str(qmp))
        self.qmp("qmp_capabilities")

    def recover(self) -> None:
        if self.alive():
            self.reached()
        else:
            self.power_cut()
            self.power_on()

    def alive(self) -> bool:
        return self.qemu is not None and self.qemu.poll() is None

    def console(self) -> str:
        return (self.place / "console.log").read_text(errors="replace")[-1000:]

    def qmp(self, command: str, *, event: str = "", **arguments: object) -> None:
        """Carries out a command of qemu's, and waits for an event."""
        message = json.dumps({"execute": command, "arguments": arguments})
        self.control.sendall(message.encode())
        self.control.settimeout(60.0)
        answered, come = False, not event
        while not (answered and come):
            said = json.loads(self.said.readline())
            if "error" in said:
                raise Wrong(f"{command}: {said['error']['desc']}")
            answered = answered or "return" in said
            come = come or said.get("event") == event

    def plug(self, chardev: str, name: str) -> None:
        kind: dict[str, object] = {
            "driver": "usb-serial",
            "always-plugged": True,
            "serial": name,
        }
        self.qmp("device_add", event="", id=name, chardev=chardev, **kind)

    def unplug(self, name: str) -> None:
        self.qmp("device_del", event="DEVICE_DELETED", id=name)

    def power_cut(self) -> None:
        if self.qemu:
            self.qemu.kill()
            self.qemu.wait()
            self.said.close()
            self.control.close()
            self.qemu = None
        super().end()

    def rebooted(self) -> None:
        """Once it has gone down, which -no-reboot makes an end of qemu."""
        assert self.qemu
        try:
            self.qemu.wait(180.0)
        except subprocess.TimeoutExpired as problem:
            raise Wrong("it does not go down") from problem
        self.power_cut()
        self.power_on()

    def end(self) -> None:
        try:
            self.power_cut()
        finally:
            self.wire.end()
            self.usb.end()
