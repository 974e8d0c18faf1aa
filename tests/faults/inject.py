#  SPDX-License-Identifier: GPL-3.0-or-later
"""Injects faults into the real supervisor and checks what must hold nevertheless."""

from __future__ import annotations

import argparse
import contextlib
import ctypes
import multiprocessing
import os
import random
import resource
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from faults import Fault, go_together
from links import Link
from parties import PROGRAMS
from standstills import Watch
from trials import ALL, Result, Trials, name_of, plan_of
from world import LOSS_LIMIT, STOP_LIMIT, Figures, World, ms

INJECTION_LIMIT = 600
#  Seconds: one not finished by then hangs: that is a violation
LONG = 4.0
#  Injections this long are started first
MOST_HEAVY = 2
FORK = multiprocessing.get_context("fork")


class Injection(NamedTuple):
    first: int
    second: int | None
    repetition: int

    @property
    def faults(self) -> tuple[Fault, ...]:
        return tuple(ALL[n] for n in (self.first, self.second) if n is not None)

    @property
    def heavy(self) -> bool:
        return any(fault.heavy for fault in self.faults)

    @property
    def order(self) -> tuple[float, str]:
        """Long ones first; those that share a world one after the other."""
        cost = sum(fault.cost for fault in self.faults)
        return -(cost if cost >= LONG else 0.0), repr(plan_of(self.faults))


def at_least(low: int, high: int = 2**31) -> Callable[[str], int]:
    def number(text: str) -> int:
        if not low <= int(text) <= high:
            raise ValueError
        return int(text)

    return number


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="script/faults", description=__doc__)
    add = parser.add_argument
    natural = at_least(0)
    add("--seed", type=natural, default=1, help="of everything random (1)")
    add("--times", type=natural, default=100, help="of each fault alone (100)")
    add("--pairs", type=natural, default=100, help="each in so many, at random (100)")
    add("--only", default="", help="faults and pairs with this in their name")
    add("--at", type=at_least(1), help="only that repetition")
    add("--jobs", type=at_least(1, 32), default=12, help="worlds side by side (12)")
    add("--short", action="store_true", help="each fault once, some pairs")
    add("--supervisor", type=Path, default=PROGRAMS / "destijl", help="(destijl)")
    add("--list", action="store_true", help="the faults' names")
    chosen = parser.parse_args()
    if chosen.short:
        chosen.times = chosen.pairs = 1
    return chosen


def pairs(seed: int, count: int) -> list[Injection]:
    """Each fault in so many, where others are short of pairs with these; round by
    round: the first are the same, however many there are."""
    source = random.Random(f"{seed} pairs")
    used: Counter[int] = Counter()
    made: list[Injection] = []
    for turn in range(1, count + 1):
        for fault in range(len(ALL)):
            if used[fault] >= turn or ALL[fault].alone:
                continue
            for attempt in range(2_000):
                other = source.randrange(len(ALL))
                if attempt < 1_000 and used[other] >= turn:
                    continue
                two = [fault, other]
                source.shuffle(two)
                if go_together(ALL[two[0]], ALL[two[1]]):
                    used.update(two)
                    made.append(Injection(two[0], two[1], len(made) + 1))
                    break
    return made


def injections(chosen: argparse.Namespace) -> list[Injection]:
    alone = [
        Injection(fault, None, repetition)
        for fault in range(len(ALL))
        for repetition in range(1, chosen.times + 1)
    ]
    wanted = [
        item
        for item in alone + pairs(chosen.seed, chosen.pairs)
        if chosen.only in name_of(item.faults) and chosen.at in (None, item.repetition)
    ]
    return sorted(wanted, key=lambda item: item.order)


class Hangs(Exception):
    """An injection has not ended in time."""


def hangs(*_: object) -> NoReturn:
    raise Hangs


def work(
    shares: list[tuple[list[Injection], Any]],
    results: Any,
    folder: Path,
    chosen: argparse.Namespace,
    watch: Watch,
) -> None:
    """A job: what is left of each of the shares, whose number taken is common to the
    jobs."""
    os.setsid()
    #  with its parent
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)
    #  which nohup ignores, and so would the supervisor
    signal.signal(signal.SIGHUP, signal.SIG_DFL)
    signal.signal(signal.SIGALRM, hangs)
    folder.chmod(0o777)
    trials = Trials(World(folder, watch, chosen.supervisor))
    try:
        for items, taken in shares:
            while True:
                with taken:
                    number, taken.value = taken.value, taken.value + 1
                if number >= len(items):
                    break
                item = items[number]
                signal.alarm(INJECTION_LIMIT)
                try:
                    result = trials.run(item.faults, chosen.seed, item.repetition)
                except Hangs:
                    trials.world.destroy()
                    result = Result("violated", account="   it has not ended\n")
                signal.alarm(0)
                results.put((item, result))
    finally:
        trials.finish()


def run(chosen: argparse.Namespace, place: Path) -> list[Result]:
    wanted = injections(chosen)
    heavy, others = (
        ([item for item in wanted if item.heavy is kind], FORK.Value("i"))
        for kind in (True, False)
    )
    watch = Watch()
    results = FORK.Queue()
    told: list[Result] = []
    jobs = []
    for number in range(min(chosen.jobs, len(wanted))):
        shares = [heavy, others] if number < MOST_HEAVY else [others]
        folder = Path(tempfile.mkdtemp(dir=place))
        jobs.append(
            FORK.Process(target=work, args=(shares, results, folder, chosen, watch))
        )
        jobs[-1].start()
    shown = time.monotonic()
    try:
        for number in range(len(wanted)):
            item, result = results.get(timeout=2 * INJECTION_LIMIT)
            told.append(result)
            tell(item, result, chosen.seed)
            if time.monotonic() - shown > 60.0:
                shown = time.monotonic()
                print(f"{number + 1} of {len(wanted)} injections", flush=True)
    finally:
        for job in jobs:
            job.terminate()
            job.join(10.0)
            assert job.pid is not None
            #  also what it has started
            with contextlib.suppress(ProcessLookupError):
                os.killpg(job.pid, signal.SIGKILL)
            job.join()
            Link(job.pid).remove()
    return told


def tell(item: Injection, result: Result, seed: int) -> None:
    name = name_of(item.faults)
    if result.end == "impossible":
        if item.second is None and item.repetition == 1:
            print(f"{name} is not possible here:\n   {result.account}", end="")
    elif result.end == "violated":
        again = f'--seed {seed} --only "{name}" --at {item.repetition}'
        print(f"VIOLATION: {name}\n{result.account}   again: {again}")
    elif result.account:
        print(f"held: {name}\n{result.account}", end="")
    sys.stdout.flush()


def main() -> None:
    chosen = options()
    if chosen.list:
        print("\n".join(fault.name for fault in ALL))
        return
    print(f"seed {chosen.seed}", flush=True)
    hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    with tempfile.TemporaryDirectory(prefix="destijl_faults.") as place:
        Path(place).chmod(0o755)
        results = run(chosen, Path(place))
    figures = Figures()
    for result in results:
        figures.add(result.figures)
    ends = Counter(result.end for result in results)
    print(
        f"{figures.stops} stops of a moving robot after a close or a reset: the slowest"
        f" after {ms(figures.slowest_stop)}, {figures.late_stops} later than the"
        f" {ms(LOSS_LIMIT + STOP_LIMIT)} demanded\n"
        f"memory grew by {figures.growth} kB at most"
    )
    if figures.repeated:
        print(
            f"{figures.repeated} sessions were begun again: the emulated line was late"
        )
    if figures.interrupted:
        print(
            f"{figures.interrupted} injections were made again: the machine's host had"
            " taken its processors"
        )
    injections = ends["held"] + ends["violated"]
    print(f"{injections} injections, {ends['violated']} violations")
    sys.exit(1 if ends["violated"] or not injections else 0)


if __name__ == "__main__":
    main()
