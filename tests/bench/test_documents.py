#  SPDX-License-Identifier: GPL-3.0-or-later
"""What script/bench --docs and script/bench missions --docs say of their page
and results: in a copy, one thing after the other is spoilt. Nothing is
measured."""

import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
RESULTS = "tests/bench/results"
PAGE = "docs/measurements.md"
MISSIONS = "docs/missions.md"
OTHER = "has other figures than the results"
FIGURE = r"/{s/[0-9]\.[0-9]/9.9/;:a;n;ba}"
ARENA = "/^<!-- table: arena -->/"


class Tree:
    def __init__(self, root: Path) -> None:
        self.root = root

    def bench(self, *arguments: str) -> tuple[int, str]:
        done = subprocess.run(
            ["script/bench", *arguments],
            cwd=self.root,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout

    def passes(self, *arguments: str) -> None:
        status, said = self.bench(*arguments)
        assert status == 0, said

    def refuses(self, words: str, *arguments: str) -> None:
        status, said = self.bench(*arguments)
        assert status != 0
        assert words in said

    def edit(self, script: str, *files: str) -> None:
        """By sed."""
        before = [(self.root / file).read_bytes() for file in files]
        subprocess.run(["sed", "-i", "-E", script, *files], cwd=self.root, check=True)
        assert before != [(self.root / file).read_bytes() for file in files]

    def folder(self, name: str, results: str) -> str:
        """As script/bench leaves these results."""
        (self.root / name).mkdir(parents=True)
        shutil.copy(self.root / RESULTS / results, self.root / name / "bench.json")
        return name

    def is_as_before(self) -> bool:
        return all(
            (self.root / path.relative_to(ROOT)).read_bytes() == path.read_bytes()
            for path in (ROOT / PAGE, *(ROOT / RESULTS).iterdir())
        )


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    shutil.copytree(ROOT / RESULTS, tmp_path / RESULTS)
    scripts = [f"tests/bench/{name}.py" for name in ("measurements", "missions")]
    for file in ("script/bench", PAGE, MISSIONS, *scripts):
        (tmp_path / file).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / file, tmp_path / file)
    return Tree(tmp_path)


def test_as_it_is(tree: Tree) -> None:
    tree.passes("--docs", "--check")
    tree.passes("missions", "--docs", "--check")


@pytest.mark.parametrize(
    ("file", "script", "words"),
    [
        (PAGE, rf"/^\| order, idle \|{FIGURE}", OTHER),
        (PAGE, r"/^\| order, idle \|/d", OTHER),
        (PAGE, r"s/^(\| order, idle .*) [0-9] of/\1 7 of/", OTHER),
        (PAGE, f"{ARENA},/^<!-- end/d", "0 tables arena, not 1"),
        (PAGE, rf"{ARENA}s/.*/&\n<!-- end -->\n\n&/", "2 tables arena, not 1"),
        (PAGE, f"{ARENA}s/arena/lost/", "0 tables arena, not 1"),
        (PAGE, f"{ARENA},/^<!-- end/{{/end/d}}", "0 tables arena, not 1"),
        (PAGE, "$a<!-- end -->", "without its other one"),
        (PAGE, r"/^\| F6 loss /s/[0-9][.,][0-9]/9.9/", OTHER),
        ("run1.json", 's/"median": [1-9]/&9/', OTHER),
        (
            "run2.json",
            "s/order, idle/order, Idle/",
            "run2.json lacks orders: order, idle",
        ),
        ("run2.json", 's/"periods"/"others"/', "run2.json lacks periods: "),
        ("run2.json", 's/, "p99": [0-9.]*//', "only some runs have "),
        (
            "run2.json",
            's/"at most": 2[.]0*,/"at most": 3,/',
            "runs with other goals: at most 2, at most 3",
        ),
        (
            "run2.json",
            "s/battery, to cyclictest/Battery, to cyclictest/",
            "run2.json lacks periods: battery, to cyclictest",
        ),
        ("hour.json", 's/"missed": [0-9]*/"missed": 77/', OTHER),
        (
            "hour.json",
            '/"name": "F11/s/"limit": [0-9]*, //',
            "hour.json lacks deadlines: F11",
        ),
    ],
)
def test_spoilt_measurements(tree: Tree, file: str, script: str, words: str) -> None:
    tree.edit(script, file if file == PAGE else f"{RESULTS}/{file}")
    tree.refuses(words, "--docs", "--check")


def test_a_goal_that_no_table_has(tree: Tree) -> None:
    files = [f"{RESULTS}/run{run}.json" for run in (1, 2)]
    tree.edit("s/battery, to cyclictest/battery/", *files)
    words = "no table has the goal periods: battery: p999_ratio"
    tree.refuses(words, "--docs", "--check")


@pytest.mark.parametrize(
    ("files", "words"),
    [
        ("run2.json", OTHER),
        ("run1-user.json", "table user: no run of an ordinary user"),
        ("hour.json", "hour.json"),
        ("*", "no results"),
    ],
)
def test_missing_results(tree: Tree, files: str, words: str) -> None:
    for file in (tree.root / RESULTS).glob(files):
        file.unlink()
    tree.refuses(words, "--docs", "--check")


def test_the_same_from_folders(tree: Tree) -> None:
    runs = [tree.folder("1", "run1.json"), tree.folder("2", "run2.json")]
    tree.folder("1/user", "run1-user.json")
    tree.refuses("3/bench.json", "--docs", *runs, "3")
    for file in (tree.root / RESULTS).glob("run*"):
        file.unlink()
    tree.edit("/order, idle/d", PAGE)
    tree.passes("--docs", *runs)
    assert tree.is_as_before()


def test_the_same_from_the_folder_of_an_hour(tree: Tree) -> None:
    hour = tree.folder("3", "hour.json")
    (tree.root / RESULTS / "hour.json").unlink()
    tree.edit(r"/^\| F6 loss /d", PAGE)
    tree.passes("--docs", "--hour", hour)
    assert tree.is_as_before()


@pytest.mark.parametrize(
    ("file", "script", "words"),
    [
        (MISSIONS, r"/^\| real, ideal /s/[0-9]\.[0-9]/99.9/", OTHER),
        (MISSIONS, r"/^\| real, all faults /d", OTHER),
        (MISSIONS, "/^<!-- end/d", "0 tables missions"),
        (RESULTS, '/"pass":/s/: ([0-9])/: 9\\1/', OTHER),
        (RESULTS, 's/"wrong": 0/"wrong": 7/', OTHER),
        (RESULTS, 's/, "slowest": [0-9.]+//', "lacks simulated, ideal: slowest"),
        (RESULTS, 's/"seed": [0-9]+/"seed": 99/', OTHER),
        (RESULTS, '/"bound":/s/: ([0-9])/: 9\\1/', OTHER),
    ],
)
def test_spoilt_missions(tree: Tree, file: str, script: str, words: str) -> None:
    tree.edit(script, MISSIONS if file == MISSIONS else f"{RESULTS}/missions.json")
    tree.refuses(words, "missions", "--docs", "--check")


#  Three missions, as bin/destijl_missions tells of them
TOLD = """{"machine": "M", "kernel": "K", "sources": "S", "begun": "B", "seed": 5,
"missions": [
{"kind": "real", "number": 1, "faults": false, "end": "done", "time": 12.0,
"exact": 10.0, "passed": 2, "pass": 8.25, "clearance": 30.5, "blind": 120,
"orders": 4, "wrong": ""},
{"kind": "real", "number": 3, "faults": false, "end": "done", "time": 16.0,
"exact": 10.0, "passed": 2, "pass": 4.0, "clearance": 21.5, "blind": 180,
"orders": 5, "wrong": ""},
{"kind": "real", "number": 2, "faults": true, "end": "no progress for 2 s",
"time": 9.0, "exact": 10.0, "passed": 1, "pass": null, "clearance": 18.0,
"blind": 150, "orders": 5, "repeated": 3, "wrong": "drives after its end"}]}
"""
#  The way of an image to its order, as script/bench responses leaves it
RESPONSES = """{"machine": "M", "kernel": "K", "sources": "R", "begun": "B",
"sections": [{"name": "responses", "title": "T", "rows": [
{"name": "image to its order's first byte", "unit": "us", "n": 1234,
"median": 40100.0, "p99": 60200.0, "p999": 70300.0, "max": 80400.0,
"goals": {"max": {"at most": 96500.0, "met": true}}}]}]}
"""


def told(tree: Tree, missions: str = TOLD, responses: str = RESPONSES) -> list[str]:
    (tree.root / "told.json").write_text(missions)
    (tree.root / "bench.json").write_text(responses)
    return ["missions", "--docs", "told.json", "."]


def test_the_tables_of_missions(tree: Tree) -> None:
    tree.passes(*told(tree))
    lines = (tree.root / MISSIONS).read_text().splitlines()
    for line in (
        "| 1,234 | 40.1 | 60.2 | 80.4 | 96.5 |",
        "| real, ideal | 2 | 2 | 0 | 0 | 0 | 8.25 | 21.5 | 180 | 1.40 | 1.60 | 1 |",
        "| real, all faults | 1 | 0 | 0 | 1 | 3 |  | 18.0 | 150 |  |  | 0 |",
        "- real 2: drives after its end",
        "- real 3: 1.60 times as long as an exact robot",
    ):
        assert line in lines
    tree.passes("missions", "--docs", "--check")


def test_results_without_missions(tree: Tree) -> None:
    tree.refuses("'missions'", *told(tree, TOLD.replace('"missions"', '"others"')))
    responses = RESPONSES.replace("image to its", "image to an")
    tree.refuses("no row image to its order", *told(tree, responses=responses))
