#  SPDX-License-Identifier: GPL-3.0-or-later
"""One supervisor for half an hour: sessions with all features, and random faults in
between. Compares the end with the beginning. Exit status: 0 all is in the end as in the
beginning, 1 not so, 2 bad usage."""

from __future__ import annotations

import argparse
import csv
import itertools
import math
import os
import random
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

from client import Monitor
from faults import Ends, Fault
from inject import at_least, programs
from ledger import USUAL, Message
from parties import await_
from standstills import TOO_LONG, Watch, host_taken, prefer_real_time
from trials import ALL, Trials, name_of
from world import World, check, descriptors, fact

LONGEST_FAULT = 12.0
#  Seconds: longer ones would leave no time for others
ANSWER_TIME_OUT = 0.08
#  The robot's answer may take so long; with that much time stolen by the host it may be
#  late without an error of the supervisor
MOST_STOLEN = 1.0
#  Percent of the processors in a judged second: two steps of 10 ms on two processors


@dataclass
class Second:
    second: float
    #  since the recording began
    calm: bool
    faults: int
    #  so far
    stolen_percent: float
    memory_kb: int
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
    faults: list[str] = field(default_factory=list)
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
                    len(self.faults),
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

    def tenth(self, last: bool) -> Tenth:
        end = self.seconds[-1].second
        first, until = (end * 0.9, math.inf) if last else (0.0, end / 10)

        def chosen(events: list[tuple[float, float]]) -> list[float]:
            return sorted(
                value
                for when, value in events
                if first <= when - self.start < until and self.quiet(when - self.start)
            )

        calm = [s for s in self.seconds if s.calm and first <= s.second < until]
        return Tenth(calm, chosen(self.answers), chosen(self.images), self)

    def write_csv(self, path: Path) -> None:
        """A line per second, which tests/bench/plots.py draws."""
        names = list(Second.__annotations__)
        with path.open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            more = "images answers median_ms p99_ms maximum_ms fault_begun"
            writer.writerow([*names, *more.split()])
            begun = 0
            for one in self.seconds:
                until = self.start + one.second
                images, answers = (
                    sorted(value for when, value in events if until - 1 <= when < until)
                    for events in (self.images, self.answers)
                )
                times = [
                    f"{quantile(answers, q) * 1000:.2f}" if answers else ""
                    for q in (0.5, 0.99, 1.0)
                ]
                fault = self.faults[one.faults - 1] if one.faults > begun else ""
                begun = one.faults
                own = vars(one) | {
                    "second": round(one.second),
                    "calm": int(one.calm),
                    "stolen_percent": f"{one.stolen_percent:.2f}",
                }
                writer.writerow(
                    [*own.values(), len(images), len(answers), *times, fault]
                )


def quantile(values: list[float], share: float) -> float:
    """The smallest that at least this share of the sorted values do not exceed."""
    place = math.ceil(share * len(values)) - 1
    return values[max(0, place)] if values else 0.0


@dataclass
class Tenth:
    calm: list[Second]
    answers: list[float]
    images: list[float]
    records: Records

    @property
    def disturbed(self) -> int:
        return sum(not self.records.quiet(one.second - 0.5) for one in self.calm)

    def median(self, name: str) -> int:
        values = [int(getattr(one, name)) for one in self.calm]
        return statistics.median_low(values) if values else 0

    def answer(self, share: float) -> float:
        """Milliseconds."""
        return quantile(self.answers, share) * 1000

    @property
    def rate(self) -> float:
        return 1 / statistics.mean(self.images) if self.images else 0.0


def judged(a: Tenth, z: Tenth) -> bool:
    """Prints the table. A leak of a kilobyte per second adds 1600 between the middles
    of the two tenths of half an hour; the other margins are for a shared machine."""
    good = True

    def line(name: str, first: str, last: str, limit: str, met: bool) -> None:
        nonlocal good
        good = good and met
        said = "yes" if met else "NO "
        print(f"| {name:24} | {first:>9} | {last:>9} | {limit:26} | {said} |")

    def count(name: str, of: Callable[[Tenth], int]) -> None:
        line(name, str(of(a)), str(of(z)), "> 0", of(a) > 0 and of(z) > 0)

    print(f"| {'':24} | 1st tenth |last tenth | {'limit':26} | met |")
    print("|---|---|---|---|---|")
    count("calm seconds", lambda t: len(t.calm))
    line(
        "not judged: the host's",
        str(a.disturbed),
        str(z.disturbed),
        "not all",
        a.disturbed < len(a.calm) and z.disturbed < len(z.calm),
    )
    count("answers", lambda t: len(t.answers))
    for name, share, margin in (
        ("median", 0.5, 0.5),
        ("p99", 0.99, 2),
        ("p99.9", 0.999, 2),
        ("maximum", 1.0, 10),
    ):
        first, last = a.answer(share), z.answer(share)
        most = 1.5 * first + margin
        limit = f"<= {most:.2f} (x 1.5 + {margin})"
        line(f"answer, {name}, ms", f"{first:.2f}", f"{last:.2f}", limit, last <= most)
    first, last = a.median("memory_kb"), z.median("memory_kb")
    limit = f"<= {first + 1024} (+ 1024)"
    line("memory, kB", str(first), str(last), limit, last <= first + 1024)
    for name in ("descriptors", "threads"):
        first, last = a.median(name), z.median(name)
        line(name, str(first), str(last), "the same", first == last)
    line(
        "images a second",
        f"{a.rate:.2f}",
        f"{z.rate:.2f}",
        "within 1 %",
        a.rate > 0.0 and abs(z.rate - a.rate) <= 0.01 * a.rate,
    )
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
            monitor.connect(self.world.port, priority=60)
            for command in ("ROPN", "RSWW", "COPN", "CPCO"):
                item = answer_to(command)
                check(item.label == "AACK", f"{command}: {item.label}")
            next_of(("CPOS",), 0)
            next_of(("CIMG",), 0)
            time.sleep(0.5)
            first = len(monitor.messages)
            prefer_real_time()
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
            records.faults.append(fault.name)
            repetition += 1
            self.inject(fault, repetition)
        records.ended.set()
        sampler.join()
        late = "; the emulated line was late, or the host had taken the processors"
        print(
            f"{minutes} minutes, {len(records.faults)} faults of {len(self.eligible)}"
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
    parser.add_argument("--minutes", type=minutes, default=30, help="how long (30)")
    parser.add_argument("--seed", type=at_least(0), help="of everything random")
    parser.add_argument("--csv", type=Path, help="write a line for each second")
    programs(parser)
    chosen = parser.parse_args()
    seed = chosen.seed
    if seed is None:
        seed = random.randrange(1_000_000)
    print(f"seed {seed}", flush=True)
    watch = Watch()
    with tempfile.TemporaryDirectory(prefix="destijl_soak.") as place:
        world = World(Path(place), watch, chosen.supervisor, chosen.emulator)
        soak = Soak(world, seed)
        try:
            good = soak.run(chosen.minutes)
        finally:
            soak.trials.finish()
        if chosen.csv:
            soak.records.write_csv(chosen.csv)
    print(
        ("" if good else "NOT ")
        + f"in the end as in the beginning, {soak.violations} violations"
    )
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
