#  SPDX-License-Identifier: GPL-3.0-or-later
"""sections, all of them if none is named: orders, answers, periods, search, tasks,
responses
--samples N   of each distribution (2000)
--seconds N   of each measurement that lasts (60)
--service     tasks, responses: as the unit starts it; the last from end to end, too;
              tasks, traces two minutes at most
--check       the same, responses from end to end alone: fails if what is demanded of
              every single case is missed
--out FOLDER  for bench.json and traces (a temporary one)
--file TRACE  for responses (some are made)
--supervisor PATH, --emulator PATH   instead of those in bin"""

import argparse
import json
import math
import re
import subprocess
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from deadlines import KEPT, Sessions
from measurements import ROOT, Row, Wrong, by_lines, machine
from responses import responses

SECTIONS = ("orders", "answers", "periods", "search", "tasks", "responses")
#  Which one can ask for; orders and answers are measured together

SHARES = {"median": 0.5, "p99": 0.99, "p999": 0.999, "max": 1.0}

NONE = (
    "longest stop, beyond the time-out and an order's p99.9"
    "|missions that did not end as meant|responses.* above their bounds"
    "|(sessions|stops|reloads|battery levels) .*|windows of the watchdog missed"
)

GOALS: tuple[tuple[str, dict[str, float]], ...] = (
    (
        "(order|answer), (idle|full load)(, as a service)?",
        {"median_ratio": 1.5, "p99_ratio": 2.0},
    ),
    (".*, with --trace, .*", {"median_ratio": 1.02}),
    (".*, default gap", {"p999": 10_000}),
    (".*, to cyclictest", {"p999_ratio": 1.5}),
    (".* search: following", {"median_ratio": 0.2}),
    (NONE, {"value": 0}),
)
#  The most of these figures of such rows; others come with their row


def quantile(times: list[float], share: float) -> float:
    """The smallest that at least this share of them does not exceed."""
    return sorted(times)[max(1, math.ceil(round(share * len(times), 6))) - 1]


def figures(name: str, times: list[float], floor: list[float]) -> Row:
    """Of a row of times in microseconds."""
    if not times:
        raise Wrong(f"{name}: nothing measured")
    row: Row = {"name": name, "unit": "us", "n": len(times)}
    row |= {
        figure: round(quantile(times, share), 3) for figure, share in SHARES.items()
    }
    for figure, share in SHARES.items() if floor else ():
        below = quantile(floor, share)
        row["floor_" + figure] = round(below, 3)
        row[figure + "_ratio"] = round(row[figure] / below, 3) if below > 0 else 0.0
    return row


def late(times: list[float], period: float) -> list[float]:
    """How much later than on the grid of the earliest each has come."""
    return from_least([time - period * round(time / period) for time in times])


def from_least(times: list[float]) -> list[float]:
    return [time - min(times) for time in times]


class Section:
    """What the lines of one make."""

    def __init__(self, name: str, title: str) -> None:
        self.name = name
        self.title = title
        self.rows: list[Row] = []
        self.notes: list[str] = []
        self.sessions = Sessions(self.notes)
        self.activities: list[bool] = []
        #  With a budget: whether they are above it
        self.stood_still = False

    def put(self, row: Row, goals: dict[str, float] | None = None) -> None:
        for names, most in GOALS:
            if re.fullmatch(names, row["name"]):
                goals = most
        if goals:
            row["goals"] = {
                figure: {"at most": most, "met": row[figure] <= most}
                for figure, most in goals.items()
            }
        self.rows.append(row)

    def put_number(self, name: str, value: float) -> None:
        self.put({"name": name, "unit": "", "value": value})

    def put_counts(self, what: str, limit: str, above: list[bool]) -> None:
        self.put_number(what, len(above))
        self.put_number(f"{what} above their {limit}", sum(above))

    def add(self, line: Row) -> None:
        if "note" in line:
            self.notes.append(line["note"])
        elif "ns" in line:
            self.add_times(line)
        elif "value" in line:
            self.put(line)
        elif "trace" in line:
            self.add_responses(line)
        elif "stood_still" in line:
            self.stood_still = line["stood_still"]
        else:
            self.sessions.add(line)

    def add_times(self, line: Row) -> None:
        times = [time / 1000 for time in line["ns"]]
        floor = [time / 1000 for time in line.get("floor", ())]
        goals = {}
        if "period" in line:
            times = late(times, line["period"])
            #  a histogram: microseconds, how many
            counts = re.findall(r"\b(\d{6}) (\d{6})\b", line.get("cyclictest", ""))
            floor = from_least([float(us) for us, n in counts for _ in range(int(n))])
        if "budget" in line:
            goals = {"p999": line["budget"]}
            self.activities += [time > line["budget"] for time in times]
        self.put(figures(line["name"], times, floor), goals)

    def add_responses(self, line: Row) -> None:
        *rows, orders = responses(line)
        above = [time > bound for _, times, bound in rows if bound for time in times]
        beside = ""
        if line["missions"]:
            if not orders[1]:
                return
            rows = [*(row for row in rows if "mission" in row[0]), orders]
            beside = " beside missions"
        for name, times, bound in rows:
            if times:
                self.put(figures(name, times, []), {"max": bound} if bound else {})
        self.put_counts("responses" + beside, "bounds", above)

    def end(self) -> None:
        if self.activities:
            self.put_counts("activities", "budgets", self.activities)
        if self.sessions.number:
            for name, times, more, goals in self.sessions.rows():
                self.put({**figures(name, times, []), **more}, goals)
            for name, count in self.sessions.counts.items():
                self.put_number(name, count)

    def table(self) -> Iterator[str]:
        def line(name: str, *cells: object) -> str:
            return f"{name:56}" + "".join(f"{cell:>11}" for cell in cells)

        yield f"\n{self.name}: {self.title}"
        yield line("   times in us", "n", "median", "p99", "p99.9", "max")
        for row in self.rows:
            if "value" in row:
                yield line(row["name"], "", f"{row['value']:,.2f}") + f" {row['unit']}"
            else:
                yield line(row["name"], row["n"], *(row[name] for name in SHARES))
            if "floor_max" in row:
                yield line("   floor", "", *(row["floor_" + name] for name in SHARES))
                yield line("   ratio", "", *(row[name + "_ratio"] for name in SHARES))
            for key, excess in ("bound", "longer"), ("limit", "missed"):
                if key in row:
                    yield (
                        f"      {key} {row[key]}: {row[excess]} are longer, "
                        f"{row[excess + '_ran']} if stand-stills are taken out"
                    )
            for figure, goal in row.get("goals", {}).items():
                met = "met" if goal["met"] else "NOT MET"
                yield f"      goal {figure} <= {goal['at most']:g}: {met}"
        yield from (f"   {note}" for note in self.notes)


class Bench:
    """A run, whose results are kept in a folder."""

    def __init__(self, folder: Path, facts: dict[str, str]) -> None:
        self.folder = folder
        self.facts = facts
        self.sections: dict[str, Section] = {}

    def measure(self, wanted: Sequence[str], program: str, *options: str) -> None:
        """What it measures, of the sections that are wanted."""
        command = [str(ROOT / "bin" / program), *options]
        sections: dict[str, Section] = {}
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            for text in process.stdout:
                if not text.startswith("{"):
                    print(text, end="")
                    continue
                line = json.loads(text)
                if "section" in line:
                    name = line["section"]
                    section = sections.setdefault(name, Section(name, line["title"]))
                else:
                    section.add(line)
        if process.returncode != 0:
            raise Wrong(f"{program} has ended with {process.returncode}")
        for name in wanted:
            if name in sections:
                self.keep(sections[name])

    def keep(self, section: Section) -> None:
        section.end()
        self.sections[section.name] = section
        print(*section.table(), sep="\n", flush=True)
        sections = [
            {
                "name": section.name,
                "title": section.title,
                "rows": [*section.rows, *({"note": note} for note in section.notes)],
            }
            for section in self.sections.values()
        ]
        text = by_lines({**self.facts, "sections": sections})
        (self.folder / "bench.json").write_text(text + "\n", encoding="utf-8")


def kept(section: Section) -> bool:
    """What is demanded of every single one."""
    return all(
        "missed_ran" not in row.get("goals", {}) or row["missed_ran"] == 0
        for row in section.rows
    ) and not any(section.sessions.counts[name] for name in KEPT)


def main() -> None:
    if sys.argv[1:] == ["--help"]:
        print(__doc__)
        return
    parser = argparse.ArgumentParser(prog="script/bench", usage="see --help")
    parser.add_argument("section", nargs="*", default=SECTIONS)
    parser.add_argument("--samples", type=int, default=2000)
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--service", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--out", type=Path, required=True)
    for name in ("--file", "--supervisor", "--emulator"):
        parser.add_argument(name)
    chosen = parser.parse_args()
    wanted = list(chosen.section)
    for name in wanted:
        if name not in SECTIONS:
            parser.error(f"no section is called {name}")
    if chosen.check:
        wanted = [name for name in wanted if name != "responses"]
    if chosen.check or (chosen.service and "responses" in wanted):
        wanted.append("deadlines")
    options = [
        text
        for name in ("samples", "seconds", "out", "file", "supervisor", "emulator")
        if (value := getattr(chosen, name)) is not None
        for text in (f"--{name}", str(value))
    ]
    if chosen.check or chosen.service:
        options.append("--service")
    chosen.out.mkdir(parents=True, exist_ok=True)
    facts = {"samples": str(chosen.samples), "seconds": str(chosen.seconds)}
    bench = Bench(chosen.out, {**machine(), **facts})
    print("\n".join(f"{name}: {text}" for name, text in bench.facts.items()))
    for together in (SECTIONS[:2], *([name] for name in (*SECTIONS[2:], "deadlines"))):
        here = [name for name in together if name in wanted]
        if here == ["search"]:
            bench.measure(here, "image_times", str(max(20, chosen.samples // 10)))
        elif here:
            bench.measure(here, "destijl_bench", *options, together[0])
    print(f"\nresults: {chosen.out}/bench.json")
    if chosen.check:
        #  a short one again where the machine stood still
        for _ in range(2):
            last = bench.sections["deadlines"]
            if kept(last) or not last.stood_still:
                break
            bench.measure(["deadlines"], "destijl_bench", *options, "deadlines")
        if not kept(bench.sections["deadlines"]):
            raise Wrong("a deadline of every single case is missed")


if __name__ == "__main__":
    try:
        main()
    except (Wrong, OSError, ValueError) as problem:
        sys.exit(f"bench: {problem}")
