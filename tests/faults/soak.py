#  SPDX-License-Identifier: GPL-3.0-or-later
"""One supervisor for half an hour: sessions with all features, and random faults in
between. Compares the end with the beginning. Exit status: 0 all is in the end as in the
beginning, 1 not so, 2 bad usage."""

from __future__ import annotations

import argparse
import itertools
import math
import os
import random
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from client import Monitor
from faults import Ends, Fault
from inject import at_least
from ledger import USUAL, Message
from parties import PROGRAMS, await_, fact
from standstills import TOO_LONG, Watch, host_taken, prefer_real_time
from trials import ALL, Trials, name_of
from world import World, check, descriptors

LONGEST_FAULT = 12.0
#  Seconds: longer ones would leave no time for others
ANSWER_TIME_OUT = 0.08
#  The robot's answer may take so long; with that much time stolen by the host it may be
#  late without an error of the supervisor
MOST_STOLEN = 1.0
#  Percent of the processors in a judged second: two steps of 10 ms on two processors

TIMES = {
    "median": (0.5, 0.5),
    "p99": (0.99, 2),
    "p99.9": (0.999, 2),
    "maximum": (1, 10),
}
#  Of the answers: the share, and the milliseconds permitted beside half as much again


@dataclass
class Second:
    second: float
    #  since the recording began
    calm: bool
    stolen_percent: float
    memory: int
    #  kB
    descriptors: int
    threads: int


@dataclass
class Records:
    """The supervisor each second, answers and images in calm periods."""

    process: int
    start: float = field(default_factory=time.monotonic)
    seconds: list[Second] = field(default_factory=list)
    answers: list[tuple[float, float]] = field(default_factory=list)
    images: list[tuple[float, float]] = field(default_factory=list)
    #  when, and how long: from a command to the supervisor's own answer, or since the
    #  image before
    calm: bool = False
    disturbed: bool = True
    #  since the last second
    ended: threading.Event = field(default_factory=threading.Event)

    def set_calm(self, calm: bool) -> None:
        """A session with all features and no fault: only completely calm seconds are
        compared."""
        self.calm = calm
        self.disturbed = self.disturbed or not calm

    def sample(self) -> None:
        taken = host_taken()
        while not self.ended.wait(
            self.start + len(self.seconds) + 1 - time.monotonic()
        ):
            calm, self.disturbed = self.calm and not self.disturbed, not self.calm
            before, taken = taken, host_taken()
            self.seconds.append(
                Second(
                    time.monotonic() - self.start,
                    calm,
                    100 * (taken - before) / (os.cpu_count() or 1),
                    fact(self.process, "VmRSS"),
                    len(descriptors(self.process)),
                    fact(self.process, "Threads"),
                )
            )

    def quiet(self, second: float) -> bool:
        """The host stole little time in it and in the one before, whose work may have
        been delayed to this one."""
        near = self.seconds[max(0, int(second) - 1) : int(second) + 1]
        return all(one.stolen_percent <= MOST_STOLEN for one in near)

    def tenth(self, last: bool) -> dict[str, float]:
        """Its figures, without what the host has disturbed."""
        end = self.seconds[-1].second
        first, until = (end * 0.9, math.inf) if last else (0.0, end / 10)

        def judged(second: float) -> bool:
            return first <= second < until and self.quiet(second)

        answers, images = (
            sorted(value for when, value in events if judged(when - self.start))
            for events in (self.answers, self.images)
        )
        calm = [one for one in self.seconds if one.calm and judged(one.second - 0.5)]
        figures: dict[str, float] = {"calm seconds": len(calm), "answers": len(answers)}
        for name, (share, _) in TIMES.items():
            figures[f"answer, {name}, ms"] = round(quantile(answers, share) * 1000, 2)
        for name in ("memory", "descriptors", "threads"):
            values = [int(getattr(one, name)) for one in calm]
            figures[name] = statistics.median_low(values or [0])
        rate = 1 / statistics.mean(images) if images else 0.0
        return figures | {"images a second": round(rate, 3)}


def quantile(values: list[float], share: float) -> float:
    """The smallest that at least this share of the sorted values do not exceed."""
    place = math.ceil(share * len(values)) - 1
    return values[max(0, place)] if values else 0.0


def limit_of(name: str, first: float, last: float) -> tuple[str, bool]:
    """And whether it is met. A leak of a kilobyte per second adds 1600 between the
    middles of the two tenths of half an hour; the other margins are for a shared
    machine."""
    match name.split(", "):
        case ["answer", kind, _]:
            most = 1.5 * first + TIMES[kind][1]
            return f"<= {most:.2f}", last <= most
        case ["memory"]:
            return f"<= {first + 1024} kB", last <= first + 1024
        case ["descriptors" | "threads"]:
            return "the same", first == last
        case ["images a second"]:
            return "within 1 %", first > 0.0 and abs(last - first) <= 0.01 * first
        case _:
            return "> 0", first > 0 and last > 0


def judged(first: dict[str, float], last: dict[str, float]) -> bool:
    """Prints the table."""
    good = True
    print(f"| {'':19} | 1st tenth |last tenth | {'limit':12} | met |")
    print("|---|---|---|---|---|")
    for name, begun in first.items():
        limit, met = limit_of(name, begun, last[name])
        good = good and met
        said = "yes" if met else "NO "
        print(f"| {name:19} | {begun:9} | {last[name]:9} | {limit:12} | {said} |")
    return good


class Soak:
    def __init__(self, world: World, seed: int) -> None:
        self.seed = seed
        self.source = random.Random(f"{seed} soak")
        self.watch = world.watch
        self.eligible = [
            #  leave the supervisor running, as most faults need it
            fault
            for fault in ALL
            if fault.plan.keys() <= {"terminal"}
            and fault.ends is not Ends.SUPERVISOR
            and fault.cost <= LONGEST_FAULT
        ]
        self.world = world
        self.trials = Trials(world, kept=True)
        self.records = Records(world.pid)
        #  what the warm-up adds is not looked at
        self.late_answers = 0
        #  of the robot, in calm sessions
        self.violations = 0

    def complain(self, text: str) -> None:
        self.violations += 1
        print(f"VIOLATION: {text}", flush=True)

    def stay_calm(self, for_time: float) -> None:
        """A session with all features, which is measured."""
        self.watch.forget()
        taken = host_taken()
        monitor = Monitor()

        def explained() -> bool:
            """By the kernel, or by the host of this machine."""
            return (
                max(self.watch.longest, self.watch.longest_line) >= TOO_LONG
                or host_taken() - taken >= ANSWER_TIME_OUT
            )

        def next_of(labels: Iterable[str], first: int) -> Message:
            def found() -> Message | None:
                new = monitor.messages[first:]
                return next((item for item in new if item.label in labels), None)

            item: Message = await_(found, f"one of {labels}", every=0.000_2)
            return item

        def answer_to(command: str) -> Message:
            first = len(monitor.messages)
            monitor.send(command.encode() + b"\n")
            return next_of(USUAL, first)

        def ask(command: str, answer: str = "AACK") -> None:
            begun = time.monotonic()
            item = answer_to(command)
            if answer == "ACER" and item.label == answer:
                self.records.answers.append((item.time, item.time - begun))
            elif answer == "AACK" and item.label in ("ATIM", "ACRJ") and explained():
                #  of an answer or of a reload
                self.late_answers += 1
            else:
                check(item.label == answer, f"{command}: {item.label}")

        try:
            prefer_real_time()
            monitor.connect(self.world.port)
            for command in ("ROPN", "RSWW", "COPN", "CPCO"):
                item = answer_to(command)
                check(item.label == "AACK", f"{command}: {item.label}")
            next_of(("CPOS",), 0)
            next_of(("CIMG",), 0)
            time.sleep(0.5)
            first = len(monitor.messages)
            self.records.set_calm(True)
            end = time.monotonic() + for_time
            while time.monotonic() <= end:
                for _ in range(4):
                    ask("what", "ACER")
                    time.sleep(self.source.uniform(0.02, 0.06))
                orders = "RGFW RGRI RMOV:-120 RTRN:45 RSTP RSTP"
                ask(self.source.choice(orders.split()))
            images = [m.time for m in monitor.messages[first:] if m.label == "CIMG"]
            for before, image in itertools.pairwise(images):
                self.records.images.append((image, image - before))
            check(monitor.broken_images == 0, "broken images")
        except AssertionError as problem:
            if explained():
                #  such as a start spoilt by the robot's silence
                self.late_answers += 1
            else:
                self.complain(f"in a calm session: {problem}")
        finally:
            self.records.set_calm(False)
            prefer_real_time(0)
            monitor.close()

    def inject(self, fault: Fault, repetition: int) -> None:
        result = self.trials.run((fault,), self.seed, repetition)
        if result.end == "violated":
            self.complain(f"{name_of((fault,))}\n{result.account}")

    def run(self, minutes: int) -> bool:
        process = self.world.pid
        #  what is allocated with the first images, and the first of each size, is not
        #  counted as growth
        self.stay_calm(5.0)
        for fault in self.eligible:
            if fault.group == "camera":
                self.inject(fault, 1)
        self.records = records = Records(process)
        sampler = threading.Thread(target=records.sample)
        sampler.start()
        end = records.start + 60 * minutes
        repetition = 1
        while self.world.port and self.world.pid == process:
            self.stay_calm(self.source.uniform(3.0, 8.0))
            if time.monotonic() >= end:
                break
            fault = self.source.choice(self.eligible)
            repetition += 1
            self.inject(fault, repetition)
        records.ended.set()
        sampler.join()
        late = "; the emulated line was late, or the host had taken the processors"
        print(
            f"{minutes} minutes, {repetition - 1} faults of {len(self.eligible)}"
            f" kinds, seed {self.seed}"
            + (f"{late}, {self.late_answers} times" if self.late_answers else "")
        )
        good = judged(records.tenth(last=False), records.tenth(last=True))
        if not self.world.port or self.world.pid != process:
            self.complain("it is no longer the same supervisor")
        return good and self.violations == 0


def main() -> None:
    parser = argparse.ArgumentParser(prog="script/soak", description=__doc__)
    #  a tenth must have several calm stretches
    minutes = at_least(2, 24 * 60)
    add = parser.add_argument
    add("--minutes", type=minutes, default=30, help="how long (30)")
    add("--seed", type=at_least(0), help="of everything random")
    add("--supervisor", type=Path, default=PROGRAMS / "destijl", help="(destijl)")
    chosen = parser.parse_args()
    seed = random.randrange(1_000_000) if chosen.seed is None else chosen.seed
    print(f"seed {seed}", flush=True)
    watch = Watch()
    with tempfile.TemporaryDirectory(prefix="destijl_soak.") as place:
        world = World(Path(place), watch, chosen.supervisor)
        soak = Soak(world, seed)
        try:
            good = soak.run(chosen.minutes)
        finally:
            soak.trials.finish()
    print(
        ("" if good else "NOT ")
        + f"in the end as in the beginning, {soak.violations} violations"
    )
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
