#  SPDX-License-Identifier: GPL-3.0-or-later
"""Random missions, simulated and real, judged by where the robot truly was.

usage: script/bench missions [--simulated N] [--real N] [--radio] [--seed N]
                             [--out FILE] [--check]
       script/bench missions --docs FILE FOLDER
       script/bench missions --docs --check

Prints a table: bin/destijl_missions carries them out and judges each. Every
other one has all faults at once. Simulated ones (1000) are the controller with
the emulator's core, in simulated time; real ones (50) the supervisor with the
emulator and rendered images, in real time, two at once; --radio has a pair of
radios between supervisor and emulator. --out keeps all
results in FILE; --check fails where a goal is missed. --docs writes the tables
of docs/missions.md from the results in FILE, and from those that
script/bench --out FOLDER responses  has left in FOLDER, and keeps what it
needs of them in tests/bench/results; with --check it fails if the page has
others."""

import argparse
import json
import statistics
import subprocess
import sys
from pathlib import Path
from typing import Any

from measurements import (
    RESULTS,
    ROOT,
    WAY,
    Row,
    Run,
    Wrong,
    by_lines,
    compare,
    grid,
    machine,
    with_tables,
)

PROGRAM = ROOT / "bin" / "destijl_missions"
PAGE = ROOT / "docs" / "missions.md"
KEPT = RESULTS / "missions.json"

SLOWEST = 1.5
#  Times that of an exact robot

AT_ONCE = 2
#  Real ones

FACTS = ("machine", "kernel", "sources", "begun")

Mission = dict[str, Any]

HEADS = {
    "name": "missions",
    "count": "number",
    "done": "done",
    "aborted": "aborted, as they say",
    "wrong": "not as they say",
    "repeated": "repeated",
    "pass": "largest distance of a point, mm",
    "clearance": "least room at a wall, mm",
    "blind": "longest drive without a new position, ms",
    "median": "time to an exact robot's, median",
    "slowest": "largest",
    "slow": f"above {SLOWEST}",
}


WAY_HEADS = {
    "n": "number",
    "median": "median, ms",
    "p99": "p99, ms",
    "max": "longest, ms",
    "bound": "bound, ms",
}


def started(*options: str) -> subprocess.Popen[str]:
    return subprocess.Popen([PROGRAM, *options], stdout=subprocess.PIPE, text=True)


def run(simulated: int, real: int, seed: int, *options: str) -> list[Mission]:
    """First the simulated ones, which need the processor."""
    missions: list[Mission] = []

    def await_end(processes: list[subprocess.Popen[str]]) -> None:
        texts = [process.communicate()[0] for process in processes]
        for process, text in zip(processes, texts, strict=True):
            if process.returncode != 0:
                raise Wrong(f"{PROGRAM.name} has ended with {process.returncode}")
            missions.extend(json.loads(line) for line in text.splitlines())

    of_seed = ("--seed", str(seed))
    if simulated > 0:
        await_end([started("--simulated", str(simulated), *of_seed)])
    shares = [(real + AT_ONCE - 1 - first) // AT_ONCE for first in range(AT_ONCE)]
    await_end(
        [
            started(
                *("--real", str(share), *of_seed),
                *("--first", str(first), "--step", str(AT_ONCE), *options),
            )
            for first, share in enumerate(shares, 1)
            if share > 0
        ]
    )
    if len(missions) != simulated + real:
        raise Wrong(f"{len(missions)} missions instead of {simulated + real}")
    return missions


def ratio(mission: Mission) -> float:
    return float(mission["time"] / mission["exact"])


def row(name: str, missions: list[Mission]) -> Row:
    """Figures are of those that are done."""
    done = [m for m in missions if m.get("end") == "done"]
    judged = [m for m in missions if "end" in m]
    ratios = [ratio(mission) for mission in done]
    wrong = sum(m["wrong"] != "" for m in missions)
    return {
        "name": name,
        "count": len(missions),
        "done": len(done),
        "aborted": sum(m["wrong"] == "" and m["end"] != "done" for m in missions),
        "wrong": wrong,
        "repeated": sum(m.get("repeated", 0) for m in missions),
        "pass": max((m["pass"] or 1e3 for m in done), default=None),
        "clearance": min((m["clearance"] for m in judged), default=None),
        "blind": max((m["blind"] for m in judged), default=None),
        "median": round(statistics.median(ratios), 3) if ratios else None,
        "slowest": round(max(ratios), 3) if ratios else None,
        "slow": sum(ratio > SLOWEST for ratio in ratios),
    }


def rows(missions: list[Mission]) -> list[Row]:
    return [
        row(f"{kind}, {'all faults' if faults else 'ideal'}", chosen)
        for kind in ("simulated", "real", "radio")
        for faults in (False, True)
        if (
            chosen := [
                m for m in missions if m["kind"] == kind and m["faults"] is faults
            ]
        )
    ]


def shown(key: str, value: Any) -> str:
    if value is None:
        return ""
    if key in ("median", "slowest"):
        return f"{value:.2f}"
    return f"{value:,}" if isinstance(value, int) else str(value)


def table(made: list[Row]) -> list[str]:
    return grid(
        list(HEADS.values()),
        ([shown(key, line[key]) for key in HEADS] for line in made),
    )


def missed(missions: list[Mission]) -> list[str]:
    """A line for each mission that misses a goal."""
    lines = []
    for mission in missions:
        what = mission["wrong"]
        if what == "" and mission["end"] != "done":
            what = f"aborted: {mission['end']}"
        elif what == "" and ratio(mission) > SLOWEST:
            what = f"{ratio(mission):.2f} times as long as an exact robot"
        if what != "":
            lines.append(f"{mission['kind']} {mission['number']}: {what}")
    return lines


def facts(seed: int) -> dict[str, Any]:
    return {**{name: machine()[name] for name in FACTS}, "seed": seed}


def about(kept: dict[str, Any]) -> str:
    return (
        f"Sources {kept['sources']}, {kept['begun']}, {kept['machine']}, "
        f"Linux {kept['kernel']}."
    )


def block(kept: dict[str, Any]) -> list[str]:
    text = [f"Seed {kept['seed']}. {about(kept)}", "", *table(kept["rows"])]
    if kept["missed"]:
        text += ["", "Goals missed:", "", *(f"- {m}" for m in kept["missed"])]
    return text


def way_of(path: Path) -> dict[str, Any]:
    run = Run(path, "")
    row = run.sections.get("responses", {}).get(WAY)
    if not row:
        raise Wrong(f"{path} has no row {WAY}")
    figures = {key: row[key] for key in WAY_HEADS if key != "bound"}
    figures["bound"] = row["goals"]["max"]["at most"]
    return {**{key: run.facts[key] for key in FACTS}, "figures": figures}


def way_block(way: dict[str, Any]) -> list[str]:
    cells = [
        f"{way['figures'][key]:,}" if key == "n" else f"{way['figures'][key] / 1e3:.1f}"
        for key in WAY_HEADS
    ]
    return [about(way), "", *grid(list(WAY_HEADS.values()), [cells])]


def written(kept: dict[str, Any]) -> str:
    for line in kept["rows"]:
        for key in HEADS:
            if key not in line:
                raise Wrong(f"{KEPT.name} lacks {line['name']}: {key}")
    return with_tables(
        PAGE,
        {"missions": lambda: block(kept), "orders": lambda: way_block(kept["way"])},
    )


def document(source: Path, responses: Path) -> None:
    results = json.loads(source.read_text(encoding="utf-8"))
    missions = results.pop("missions")
    kept = {
        **results,
        "rows": rows(missions),
        "missed": missed(missions),
        "way": way_of(responses / "bench.json"),
    }
    page = written(kept)
    KEPT.write_text(by_lines(kept) + "\n", encoding="utf-8")
    PAGE.write_text(page, encoding="utf-8")
    print(f"written: {PAGE}")


def main(arguments: list[str]) -> None:
    if arguments == ["--docs", "--check"]:
        compare(PAGE, written(json.loads(KEPT.read_text(encoding="utf-8"))))
        return
    if arguments[:1] == ["--docs"]:
        if len(arguments) != 3:
            raise Wrong("--docs needs the results of --out and of responses")
        document(Path(arguments[1]), Path(arguments[2]))
        return
    parser = argparse.ArgumentParser(
        prog="script/bench missions",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        usage=argparse.SUPPRESS,
    )
    parser.add_argument("--simulated", type=int, default=1000, help="(1000)")
    parser.add_argument("--real", type=int, default=50, help="(50)")
    parser.add_argument("--radio", action="store_true", help="real ones by radio")
    parser.add_argument("--seed", type=int, default=1, help="others (1)")
    parser.add_argument("--out", type=Path, help="file for all results, as JSON")
    parser.add_argument("--check", action="store_true", help="fail if a goal is missed")
    chosen = parser.parse_args(arguments)
    now = facts(chosen.seed)
    radio = ["--radio"] if chosen.radio else []
    missions = run(chosen.simulated, chosen.real, chosen.seed, *radio)
    if chosen.out is not None:
        text = by_lines({**now, "missions": missions}) + "\n"
        chosen.out.write_text(text, encoding="utf-8")
    print("\n".join(table(rows(missions))))
    complaints = missed(missions)
    print("\n".join(complaints))
    if chosen.check and complaints:
        raise Wrong(f"{len(complaints)} missions miss a goal")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (Wrong, KeyError, OSError, ValueError) as problem:
        sys.exit(f"missions: {problem}")
