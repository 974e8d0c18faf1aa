#  SPDX-License-Identifier: GPL-3.0-or-later
"""A simulated cable to another machine: a pair of virtual interfaces and a network
namespace. It can be cut in every way. Names and addresses are of the process: several
may have one at a time."""

import contextlib
import ctypes
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

CLONE_NEWNET = 0x4000_0000


class Skipped(Exception):
    """This machine does not permit it; the message says why."""


def succeeds(command: str) -> bool:
    return subprocess.run(command.split(), capture_output=True).returncode == 0


def run(command: str) -> None:
    assert succeeds(command), f"failed: {command}"


@contextlib.contextmanager
def inside(namespace: str) -> Iterator[None]:
    """The calling thread; "": where it is."""
    if not namespace:
        yield
        return
    setns = ctypes.CDLL(None).setns
    with (
        open("/proc/thread-self/ns/net") as home,
        open(f"/run/netns/{namespace}") as it,
    ):
        assert setns(it.fileno(), CLONE_NEWNET) == 0, f"cannot enter {namespace}"
        try:
            yield
        finally:
            assert setns(home.fileno(), CLONE_NEWNET) == 0, "cannot leave it"


class Link:
    def __init__(self, process: int | None = None) -> None:
        number = process or os.getpid()
        self.name, self.here, self.there = (
            f"{what}{number}" for what in ("destijl", "dsh", "dst")
        )
        #  nets of four addresses, from 10.213.0.0 on
        place = number % (64 * 200)
        self.net, self.supervisor_side, self.monitor_side = (
            f"10.213.{place // 64}.{place % 64 * 4 + host}" for host in range(3)
        )
        #  left when the others are gone: no packet leaves by the machine's network
        self.nowhere = f"unreachable {self.net}/30 metric 4096"
        self.namespace = ""

    def run_there(self, command: str) -> None:
        """Not by ip -n, which mounts a /sys of its own and fails where / is no mount
        point."""
        with inside(self.name):
            run(command)

    def make(self) -> None:
        if os.geteuid() != 0:
            raise Skipped("only root can make a network namespace")
        if shutil.which("ip") is None:
            raise Skipped("there is no ip command here (package iproute2)")
        if not succeeds(f"ip netns add {self.name}"):
            raise Skipped("network namespaces are not allowed here")
        self.namespace = self.name
        run(f"ip link add {self.here} type veth peer name {self.there}")
        run(f"ip link set {self.there} netns {self.name}")
        run(f"ip addr add {self.supervisor_side}/30 dev {self.here}")
        run(f"ip link set {self.here} up")
        run(f"ip route add {self.nowhere}")
        self.run_there(f"ip addr add {self.monitor_side}/30 dev {self.there}")
        self.run_there(f"ip link set {self.there} up")

    def change(self, how: str, breaks: bool) -> None:
        """Cuts it, or mends it: what is not cut stays as it is."""

        def interface(name: str) -> str:
            return f"ip link set {name} {'down' if breaks else 'up'}"

        def address(of: str, name: str) -> str:
            return f"ip addr {'del' if breaks else 'replace'} {of}/30 dev {name}"

        def station(of: str, name: str) -> str:
            #  one that is not there
            if breaks:
                false = "lladdr 02:00:00:00:00:99 nud permanent"
                return f"ip neigh replace {of} dev {name} {false}"
            return f"ip neigh flush to {of} dev {name} nud permanent"

        match how:
            case "cable pulled":  # at the monitor's end: no carrier at the supervisor's
                self.run_there(interface(self.there))
            case "monitor gone":  # its machine does not answer
                self.run_there(address(self.monitor_side, self.there))
            case "dropped there":  # no packet gets to the monitor
                run(station(self.monitor_side, self.here))
            case "dropped here":  # none gets from it
                self.run_there(station(self.supervisor_side, self.there))
            case "interface down":  # of the supervisor's machine
                run(interface(self.here))
            case "address gone":  # the same
                run(address(self.supervisor_side, self.here))
            case "route gone":  # the same: none to the monitor, but from it
                route = f"{self.net}/30 dev {self.here} src {self.supervisor_side}"
                run(f"ip route {'del' if breaks else 'replace'} {route}")

    def remove(self) -> None:
        """If it exists, perhaps left by a killed process."""
        self.namespace = ""
        if Path(f"/run/netns/{self.name}").exists():
            succeeds(f"ip link del {self.here}")
            succeeds(f"ip route del {self.nowhere}")
            succeeds(f"ip netns del {self.name}")
