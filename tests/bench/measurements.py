#  SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of docs/measurements.md, from the results of script/bench.

usage: script/bench --docs FOLDER ... | --hour FOLDER | --check

Each FOLDER is of one run, with its bench.json, and user/bench.json of the same
as an ordinary user; that of --hour is of an hour as the service. The results
are kept in tests/bench/results, the page is written anew from them. --check
fails if the page is not what they make."""

import difflib
import json
import os
import platform
import re
import sys
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "measurements.md"
RESULTS = ROOT / "tests" / "bench" / "results"
HOUR = RESULTS / "hour.json"

MACHINE = {"machine": ("run", "user"), "hour-machine": ("hour",)}
#  The tables of the facts of each run of these kinds

Row = dict[str, Any]

WAY = "image to its order's first byte"
#  A row: the way of an image to the order of a mission


class Wrong(Exception):
    """What results or page lack."""


def machine() -> dict[str, str]:
    """What the results are of."""

    def line(path: str, part: str = "") -> str:
        try:
            text = Path(path).read_text(encoding="utf-8", errors="replace")
        except OSError:
            return ""
        return next((one for one in text.rstrip("\0").splitlines() if part in one), "")

    processors = "/sys/devices/system/cpu"
    board = line("/sys/firmware/devicetree/base/model")
    model = line("/proc/cpuinfo", "model name").partition(":")[2].strip()
    virtual = ", virtual" if line("/proc/cpuinfo", "hypervisor") else ""
    real_time = ", real-time priorities"
    try:
        os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(99))
        os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
    except OSError:
        real_time = ", no real-time priorities"
    return {
        "machine": f"{board or model or 'unknown processor'}, {os.cpu_count()} cores"
        + virtual,
        "kernel": platform.release()
        + (", " if line("/sys/kernel/realtime", "1") else ", not ")
        + "PREEMPT_RT",
        "governor": (
            line(f"{processors}/cpu0/cpufreq/scaling_governor") or "none visible"
        )
        + ", idle states: "
        + (line(f"{processors}/cpuidle/current_driver") or "none visible"),
        "user": ("root" if os.geteuid() == 0 else "an ordinary user") + real_time,
        "sources": os.environ.get("DESTIJL_COMMIT", "unknown"),
        "begun": time.strftime("%Y-%m-%d %H:%M:%S UTC", time.gmtime()),
    }


@dataclass
class Table:
    """Rows of these sections, whose names match; a line for each figure that a
    row has, a column for each run of that kind. wide: a line for each row, a
    column for each figure, and no goals, whose figures must be among them."""

    sections: tuple[str, ...]
    figures: tuple[str, ...]
    names: str = ".*"
    kind: str = "run"
    wide: bool = False


ORDERS = ("orders", "answers")
PLAIN = r"(order|answer), (?!.*(relay|--trace|default gap)).*"
FEATURE = r"F\d+ .*"

TABLES = {
    "ratios": Table(ORDERS, ("median_ratio", "p99_ratio"), PLAIN),
    "times": Table(ORDERS, ("median", "floor_median", "p99", "floor_p99"), PLAIN),
    "silent": Table(ORDERS, ("p999", "max", "value"), ".*stop.*|.*default gap"),
    "user": Table(ORDERS, ("median_ratio", "p99_ratio", "p99"), PLAIN, kind="user"),
    "periods": Table(
        ("periods",),
        ("p999_ratio", "p999", "floor_p999", "median_ratio", "median", "floor_median"),
        ".*, to cyclictest",
    ),
    "trace": Table(ORDERS, ("median_ratio", "p99_ratio", "median"), ".*--trace.*"),
    "search": Table(("search",), ("median_ratio", "median"), ".* search: .*"),
    "arena": Table(("search",), ("median",), r"\S+ arena"),
    "markers": Table(
        ("search",),
        ("median_ratio", "median"),
        ".* [1-4] in view: (following|whole image)",
    ),
    "responses": Table(("responses",), ("max", "value")),
    "tasks": Table(("tasks",), ("n", "p999", "value")),
    "hour-times": Table(
        ("deadlines",), ("n", "median", "p99", "p999", "max"), FEATURE, "hour", True
    ),
    "hour-bounds": Table(
        ("deadlines",), ("bound", "longer", "longer_ran"), FEATURE, "hour", True
    ),
    "hour-deadlines": Table(
        ("deadlines",), ("limit", "of", "missed", "missed_ran"), FEATURE, "hour", True
    ),
    "hour-numbers": Table(("deadlines",), ("value",), "(?!F).*", "hour"),
    "hour-responses": Table(("responses",), ("n", "max", "value"), kind="hour"),
    "hour-tasks": Table(("tasks",), ("n", "p999", "value"), kind="hour"),
}

LABELS = {
    "p999": "p99.9",
    "max": "longest",
    "n": "samples",
    "longer": "longer",
    "longer_ran": "longer without stand-stills",
    "limit": "demanded",
    "of": "of",
    "missed": "longer",
    "missed_ran": "longer without stand-stills",
}

COUNTS = ("n", "longer", "longer_ran", "of", "missed", "missed_ran")
#  Figures without a unit


class Run:
    """One bench.json."""

    def __init__(self, path: Path, name: str) -> None:
        read = json.loads(path.read_text(encoding="utf-8"))
        self.path = path
        self.name = name
        self.sections: dict[str, dict[str, Row]] = {}
        for section in read.pop("sections"):
            rows = self.sections.setdefault(section["name"], {})
            for row in section["rows"]:
                if "note" in row:
                    continue
                if row["name"] in rows:
                    raise Wrong(f"{path}: {section['name']}: {row['name']} twice")
                if "missed" in row:
                    every = "missed_ran" in row["goals"]
                    row["of"] = "every one" if every else "99.9 %"
                rows[row["name"]] = row
        self.facts: dict[str, str] = read

    def rows(self, table: Table) -> dict[tuple[str, str], Row]:
        return {
            (section, name): row
            for section in table.sections
            for name, row in self.sections.get(section, {}).items()
            if re.fullmatch(table.names, name)
        }


Results = dict[str, list[Run]]
#  As root: run, as an ordinary user: user, an hour as the service: hour


def load(folder: Path, runs: list[tuple[Path, Path]], hour: Path) -> Results:
    """The runs in these files; those of an ordinary user where there are."""
    if not runs:
        raise Wrong(f"{folder}: no results")
    numbered = list(enumerate(runs, 1))
    return {
        "run": [Run(path, f"run {number}") for number, (path, _) in numbered],
        "user": [
            Run(of_user, f"user {n}")
            for n, (_, of_user) in numbered
            if of_user.exists()
        ],
        "hour": [Run(hour, "the hour")],
    }


def recorded(hour: Path = HOUR) -> Results:
    paths = sorted(RESULTS.glob("run*.json"))
    files = [path for path in paths if "-" not in path.name]
    return load(RESULTS, [(path, of_user(path)) for path in files], hour)


def of_user(path: Path) -> Path:
    return path.with_name(path.stem + "-user.json")


def shown(value: float | str, figure: str, unit: str) -> str:
    """With three digits or so."""
    if isinstance(value, str):
        return value
    size = abs(value)
    if figure in COUNTS or unit == "":
        return f"{value:,.0f}"
    if "ratio" in figure and size < 2:
        return f"{value:.3f}"
    return f"{value:,.{0 if size >= 100 else 1 if size >= 10 else 2}f}"


def label(figure: str, unit: str) -> str:
    if figure == "value":
        return unit or "number"
    if figure.endswith("_ratio"):
        figure = figure.removesuffix("_ratio")
        return "ratio, " + LABELS.get(figure, figure)
    name = figure.removeprefix("floor_")
    text = ("floor, " if name != figure else "") + LABELS.get(name, name)
    return text + (f", {unit}" if name not in COUNTS else "")


def goal_of(rows: list[Row], figure: str, what: str) -> list[str]:
    """Its cells: the goal, and in how many runs it was met."""
    goals = [row.get("goals", {}).get(figure, {}) for row in rows]
    limits = [f"at most {g['at most']:,g}" if g else "" for g in goals]
    if len(set(limits)) > 1:
        raise Wrong(f"{what}: runs with other goals: {', '.join(limits)}")
    if not limits[0]:
        return ["", ""]
    return [limits[0], f"{sum(goal['met'] for goal in goals)} of {len(goals)}"]


def cell_line(cells: Iterable[str]) -> str:
    return "| " + " | ".join(cells) + " |"


def grid(heads: list[str], cells: Iterable[Iterable[str]]) -> list[str]:
    """A table's lines."""
    return [cell_line(heads), "|---" * len(heads) + "|", *map(cell_line, cells)]


def wide(table: Table, run: Run, seen: set[tuple[str, ...]]) -> list[str]:
    """The same for one run, a column for each figure; without rows that have
    none of them."""
    rows = {
        key: row
        for key, row in run.rows(table).items()
        if any(figure in row for figure in table.figures)
    }
    if not rows:
        raise Wrong(f"{run.path} has no rows of it")
    for key, row in rows.items():
        for figure in table.figures:
            if figure not in row:
                raise Wrong(f"{run.path} lacks {': '.join(key)}: {figure}")
            seen.add((*key, figure))
    return grid(
        ["what", *(label(figure, "us") for figure in table.figures)],
        (
            [key[1], *(shown(row[figure], figure, "us") for figure in table.figures)]
            for key, row in rows.items()
        ),
    )


def lines(table: Table, runs: list[Run], seen: set[tuple[str, ...]]) -> list[str]:
    """Of the table. Notes in seen which goals they have."""
    if not runs:
        raise Wrong("no run of an ordinary user (--user)")
    found = [run.rows(table) for run in runs]
    every = {key: None for rows in found for key in rows}
    for section in table.sections:
        if section not in {key[0] for key in every}:
            raise Wrong(f"no rows of section {section}")
    cells = []
    present = set()
    for key in every:
        for run, rows in zip(runs, found, strict=True):
            if key not in rows:
                raise Wrong(f"{run.path} lacks {': '.join(key)}")
        of_all = [rows[key] for rows in found]
        for figure in table.figures:
            having = [row for row in of_all if figure in row]
            if not having:
                continue
            what = f"{': '.join(key)}: {figure}"
            if len(having) < len(runs):
                raise Wrong(f"only some runs have {what}")
            present.add(figure)
            seen.add((*key, figure))
            unit = str(having[0]["unit"])
            cells.append(
                [
                    key[1],
                    label(figure, unit),
                    *(shown(row[figure], figure, unit) for row in having),
                    *goal_of(having, figure, what),
                ]
            )
    for figure in table.figures:
        if figure not in present:
            raise Wrong(f"no row has {figure}")
    heads = ["what", "figure", *(run.name for run in runs), "goal", "met in"]
    if not any(line[-1] for line in cells):
        heads, cells = heads[:-2], [line[:-2] for line in cells]
    if len({line[1] for line in cells}) == 1:
        heads = [cells[0][1], *heads[2:]]
        cells = [[line[0], *line[2:]] for line in cells]
    before = ["", *(line[0] for line in cells)]
    return grid(
        heads,
        (
            ["" if line[0] == last else line[0], *line[1:]]
            for last, line in zip(before, cells, strict=False)
        ),
    )


def facts(runs: list[Run]) -> list[str]:
    names = list(runs[0].facts)
    for name in names:
        if any(name not in run.facts for run in runs):
            raise Wrong(f"only some runs have {name}")
    return grid(
        ["", *(run.name for run in runs)],
        ([name, *(run.facts[name] for run in runs)] for name in names),
    )


def with_tables(path: Path, tables: dict[str, Callable[[], Iterable[str]]]) -> str:
    """The page with these tables between their markers; it has no others."""

    def table(match: re.Match[str]) -> str:
        name = match[1]
        if name not in tables:
            raise Wrong(f"{path.name}: no such table: {name}")
        try:
            text = "\n".join(tables[name]())
        except Wrong as problem:
            raise Wrong(f"table {name}: {problem}") from None
        return f"<!-- table: {name} -->\n\n{text}\n\n<!-- end -->\n"

    page = path.read_text(encoding="utf-8")
    block = re.compile(
        r"^<!-- table: (\S+) -->\n((?!<!-- table).*\n)*?<!-- end -->\n", re.M
    )
    names = [match[1] for match in block.finditer(page)]
    for name in tables:
        if names.count(name) != 1:
            raise Wrong(f"{path.name}: {names.count(name)} tables {name}, not 1")
    if len(re.findall("^<!-- ", page, re.M)) != 2 * len(names):
        raise Wrong(f"{path.name}: a marker without its other one")
    return block.sub(table, page)


def compare(path: Path, made: str) -> None:
    page = path.read_text(encoding="utf-8")
    if made != page:
        changes = difflib.unified_diff(
            page.splitlines(), made.splitlines(), "page", "results", lineterm=""
        )
        print("\n".join(changes))
        raise Wrong(f"{path.name} has other figures than the results")


def written(results: Results) -> str:
    """The page with the tables of these results."""
    seen: dict[str, set[tuple[str, ...]]] = {kind: set() for kind in results}

    def rows(table: Table) -> Iterable[str]:
        runs = results[table.kind]
        if table.wide:
            return wide(table, runs[0], seen[table.kind])
        return lines(table, runs, seen[table.kind])

    tables: dict[str, Callable[[], Iterable[str]]] = {
        name: partial(facts, [run for kind in kinds for run in results[kind]])
        for name, kinds in MACHINE.items()
    }
    tables |= {name: partial(rows, table) for name, table in TABLES.items()}
    page = with_tables(PAGE, tables)
    for kind in ("run", "hour"):
        for section, named in results[kind][0].sections.items():
            for name, row in named.items():
                for figure in row.get("goals", {}):
                    if (section, name, figure) not in seen[kind]:
                        raise Wrong(
                            f"no table has the goal {section}: {name}: {figure}"
                        )
    return page


def by_lines(value: Any) -> str:
    """As JSON, a line for each object that has no list in it."""
    if isinstance(value, list):
        return "[\n" + ",\n".join(map(by_lines, value)) + "]"
    if isinstance(value, dict) and any(isinstance(v, list) for v in value.values()):
        members = (f"{json.dumps(key)}: {by_lines(v)}" for key, v in value.items())
        return "{" + ",\n".join(members) + "}"
    return json.dumps(value)


def kept(run: Run, kind: str) -> str:
    """Of its results those that a table has."""
    used = {
        key: row
        for table in TABLES.values()
        if table.kind == kind
        for key, row in run.rows(table).items()
        if any(figure in row for figure in table.figures)
    }
    sections = [
        {
            "name": section,
            "rows": [row for name, row in rows.items() if (section, name) in used],
        }
        for section, rows in run.sections.items()
    ]
    return by_lines({**run.facts, "sections": sections}) + "\n"


def keep(results: Results) -> None:
    texts = {HOUR.name: kept(results["hour"][0], "hour")}
    for kind, end in (("run", ""), ("user", "-user")):
        for run in results[kind]:
            number = run.name.rpartition(" ")[2]
            texts[f"run{number}{end}.json"] = kept(run, kind)
    RESULTS.mkdir(exist_ok=True)
    for path in RESULTS.glob("run*.json"):
        path.unlink()
    for name, text in texts.items():
        (RESULTS / name).write_text(text, encoding="utf-8")


def main(arguments: list[str]) -> None:
    if arguments == ["--check"]:
        compare(PAGE, written(recorded()))
        return
    if arguments[:1] == ["--hour"]:
        if len(arguments) != 2:
            raise Wrong("--hour needs one folder")
        results = recorded(Path(arguments[1]) / "bench.json")
    else:
        folders = [Path(argument) for argument in arguments]
        results = load(
            Path(),
            [(f / "bench.json", f / "user" / "bench.json") for f in folders],
            HOUR,
        )
    made = written(results)
    keep(results)
    PAGE.write_text(made, encoding="utf-8")
    print(f"written: {PAGE}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (Wrong, OSError, ValueError) as problem:
        sys.exit(f"measurements: {problem}")
