#  SPDX-License-Identifier: GPL-3.0-or-later
"""script/prove notices what makes its record wrong: in a small tree, with a
record that a stand-in for GNATprove made, one thing after the other is spoilt."""

import os
import shutil
from pathlib import Path

import pytest
from parties import ROOT, ran

PROVE = ROOT / "script/prove"
BODY = "src/robot/whole.adb"
RECORD = "proofs/results"

FILES = {
    "README.md": "| GNATprove | 0 checks, 0 unproved, of nothing |\n",
    "destijl.adc": "pragma Profile (Ravenscar);\n",
    "destijl.gpr": "project Destijl is end Destijl;\n",
    "proofs/proofs.gpr": '("--mode=all", "--steps=1")\n',
    "vision_c/vision.h": "int vision;\n",
    "tests/emulator/core/core.ads": "package Core with SPARK_Mode is\nend Core;\n",
    "src/robot/whole.ads": "package Whole with SPARK_Mode is\nend Whole;\n",
    BODY: "package body Whole with SPARK_Mode is\nend Whole;\n",
    "src/robot/queues.ads": "generic\npackage Queues with SPARK_Mode is\nend Queues;\n",
    "src/process/calls.ads": "generic\npackage Calls with SPARK_Mode is\nend Calls;\n",
    "src/process/calls.adb": """--  Outside
package body Calls with SPARK_Mode => Off is

end Calls;
""",
    "src/process/used.ads": """package Used with SPARK_Mode is
   package One is new Calls;
   pragma Warnings (Off);
end Used;
""",
    "proofs/README.md": """
| `src/process/calls.adb` | 2 | calls |
| `src/process/used.ads` | `Warnings` | 1 | wanted |
""",
}
UNITS = {"core": 3, "whole": 3, "used": 2}
"""The subprograms, of 3, that are analysed."""

VERSIONS = """0.0w
Why3 for gnatprove version 0.0
/a/folder/z3: Z3 version 0.3
compiled with GCC
"""

STAND_IN = """#!/bin/sh
[ "$*" != --version ] || exec cat "$STAND_IN/versions"
mkdir -p ../obj/proofs
cp -R "$STAND_IN/results" ../obj/proofs/gnatprove
echo "a.adb:1:1: error: wrong"
exit "${STATUS-0}"
"""


def result(folder: Path, justified: str = ".", unproved: str = ".") -> None:
    """What GNATprove reports."""
    folder.mkdir(exist_ok=True)
    units = [
        f"in unit {unit}, {some} subprograms and packages out of 3 analyzed\n"
        for unit, some in UNITS.items()
    ]
    total = f"Total    6   3 (50%)   .   3 (50%)   {justified}   {unproved}\n"
    head = f"Summary\n{total}\nmax steps used: 1\n"
    (folder / "gnatprove.out").write_text(head + "".join(units))


class Tree:
    def __init__(self, root: Path) -> None:
        self.root = root
        self.stand_in = root.parent / "stand_in"
        self.environment = os.environ | {
            "PATH": f"{self.stand_in}:{os.environ['PATH']}",
            "STAND_IN": str(self.stand_in),
        }

    def run(self, *parts: str, **more: str) -> tuple[int, str]:
        return ran("script/prove", *parts, cwd=self.root, env=self.environment | more)

    def refuses(self, words: str, *parts: str, **more: str) -> None:
        status, said = self.run(*(parts or ["record"]), **more)
        assert status == 1
        assert words in said

    def passes(self, words: str, *parts: str) -> None:
        status, said = self.run(*parts)
        assert status == 0, said
        assert words in said

    def add(self, file: str, text: str) -> None:
        """Before the last line of the file."""
        path = self.root / file
        lines = path.read_text().splitlines(keepends=True)
        path.write_text("".join([*lines[:-1], f"{text}\n", *lines[-1:]]))

    def edit(self, file: str, old: str, new: str) -> None:
        path = self.root / file
        text = path.read_text()
        assert old in text
        path.write_text(text.replace(old, new, 1))


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the tree and the stand-in."""
    tree = Tree(tmp_path_factory.mktemp("made") / "tree")
    for file, text in FILES.items():
        path = tree.root / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    (tree.root / "script").mkdir()
    shutil.copy(PROVE, tree.root / "script/prove")
    tree.stand_in.mkdir()
    (tree.stand_in / "versions").write_text(VERSIONS)
    result(tree.stand_in / "results")
    for name, text in (("gnatprove", STAND_IN), ("gnat", "#!/bin/sh\necho GNAT 0.4\n")):
        (tree.stand_in / name).write_text(text)
        (tree.stand_in / name).chmod(0o755)
    tree.passes("proved  6 checks, 0 unproved, recorded", "update")
    return tree.root.parent


@pytest.fixture
def tree(made: Path, tmp_path: Path) -> Tree:
    shutil.copytree(made, tmp_path, dirs_exist_ok=True)
    return Tree(tmp_path / "tree")


def test_the_record_and_another_run_agree(tree: Tree) -> None:
    assert "6 checks, 0 unproved" in (tree.root / "README.md").read_text()
    tools = (tree.root / RECORD / "tools.txt").read_text().splitlines()
    versions = [
        "gnatprove 0.0w",
        "Why3 for gnatprove version 0.0",
        "z3: Z3 version 0.3",
    ]
    assert tools == [
        *versions,
        "GNAT 0.4",
        "",
        "switches:",
        "   --mode=all",
        "   --steps=1",
    ]
    tree.passes("", "installed")
    tree.passes("record  6 checks, 0 unproved", "record", "gnatprove")
    (tree.stand_in / "results/gnatprove.out").unlink()
    tree.refuses("no result of GNATprove", "gnatprove")


def test_gnatprove_of_the_crate_is_found(tree: Tree) -> None:
    alire = tree.stand_in.parent / "alire"
    alire.mkdir()
    (alire / "alr").write_text(
        f'#!/bin/sh\nshift 3\nPATH={tree.stand_in}:$PATH exec "$@"\n'
    )
    (alire / "alr").chmod(0o755)
    tree.environment["PATH"] = f"{alire}:/usr/bin:/bin"
    if shutil.which("gnatprove", path=tree.environment["PATH"]):
        pytest.skip("a GNATprove is installed")
    tree.refuses("gnatprove: not installed", "installed")
    (tree.root / "proofs/alire").mkdir()
    tree.passes("proved  6 checks, 0 unproved, recorded", "update")


def test_a_run_that_does_not_prove_all_is_refused(tree: Tree) -> None:
    tree.refuses("gnatprove: 1 messages above", "update", STATUS="1")
    for kind in ("justified", "unproved"):
        result(tree.stand_in / "results", **{kind: "3 (50%)"})
        tree.refuses("6 checks, 3 unproved", "update")


@pytest.mark.parametrize(
    "name", ["sources.txt", "summary.txt", "tools.txt", "units.txt"]
)
def test_a_file_of_the_record_is_missing(tree: Tree, name: str) -> None:
    (tree.root / RECORD / name).unlink()
    tree.refuses(f"{RECORD}/{name} is missing")


@pytest.mark.parametrize("file", [file for file in FILES if not file.endswith(".md")])
def test_a_file_has_changed(tree: Tree, file: str) -> None:
    """That does not make the record wrong, but old."""
    with (tree.root / file).open("a") as text:
        text.write("more\n")
    tree.refuses(f"not proved as they are now (script/prove update): {file}")
    tree.passes("6 checks, 0 unproved, of commit no commit; changed", "standing")
    tree.passes("since then: 1 units", "standing")


def test_comments_and_layout_are_not_proved(tree: Tree) -> None:
    tree.edit(BODY, "package body Whole", "--  A body\n\npackage  body Whole")
    tree.passes("recorded for these sources", "record")
    tree.add(BODY, 'X : constant String := "--  a";')
    tree.refuses(BODY)
    tree.passes("", "update")
    tree.edit(BODY, '"--  a"', '"--  b"')
    tree.refuses(BODY)


@pytest.mark.parametrize(
    ("construct", "text"),
    [
        ("Assume", "pragma Assume (True);"),
        (
            "Assume",
            'X : String := "--"; C : Character := \'"\'; PRAGMA\n  assume (True);',
        ),
        ("Assume", "pragma Check (Assume, False);"),
        ("Annotate", 'pragma Annotate (GNATprove, Intentional, "a", "b");'),
        ("Annotate", "procedure X with Annotate => (GNATprove, Skip_Proof);"),
        ("Annotate", 'X : A with Annotate=>(GNATprove,\n  False_Positive, "a", "b");'),
        ("Warnings", "pragma Warnings (Off);"),
        ("Warnings", 'pragma Warnings ("-gnatwA");'),
        ("Warnings", "X : A with Volatile, Warnings\n  =>Off;"),
        ("Unchecked_", "function X is new Ada.Unchecked_Conversion (A, B);"),
        ("Unchecked_", "X : Y := Z'Unchecked_Access;"),
        ("Import", "procedure X with Import, Convention => C;"),
        ("Import", "pragma Interface (C, X);"),
    ],
)
def test_an_exception_is_not_documented(tree: Tree, construct: str, text: str) -> None:
    tree.add(BODY, text)
    tree.refuses(f'"Exceptions" differs from the sources: -{BODY} {construct} 1')


def test_no_exceptions(tree: Tree) -> None:
    tree.add(BODY, "--  pragma Assume (True); pragma SPARK_Mode (Off);")
    tree.add(BODY, 'X : String := "pragma Assume (True); SPARK_Mode => Off";')
    tree.add(BODY, "pragma Warnings (On); pragma Annotate (GNATprove, Terminating, X);")
    tree.add(BODY, "procedure X with Annotate => (GNATprove, Terminating);")
    tree.passes("proved  6 checks", "update")


def test_the_table_of_exceptions_is_wrong(tree: Tree) -> None:
    tree.edit("proofs/README.md", "`Warnings` | 1 | wanted", "`Warnings` | 1 | ")
    tree.refuses("-src/process/used.ads Warnings 1")
    tree.add("proofs/README.md", f"| `{BODY}` | `Assume` | 1 | for no reason |")
    tree.refuses(f"+{BODY} Assume 1")


@pytest.mark.parametrize(
    "text",
    [
        "procedure X with SPARK_Mode => Off;",
        "pragma SPARK_Mode (Off);",
        "pragma SPARK_Mode (Mode => Off);",
        "PRAGMA spark_mode(off);",
        "package X with Pure, Spark_Mode=>OFF is end X;",
    ],
)
@pytest.mark.parametrize("file", [BODY, "destijl.adc"])
def test_what_is_outside_spark_is_not_documented(
    tree: Tree, file: str, text: str
) -> None:
    tree.add(file, text)
    tree.refuses(f'"Outside SPARK" differs from the sources: -{file} ')


def test_a_body_outside_spark_has_grown(tree: Tree) -> None:
    tree.add("src/process/calls.adb", "   A : B;\n   --  C")
    tree.refuses("+src/process/calls.adb 2, -src/process/calls.adb 3")


def test_a_source_does_not_state_its_mode(tree: Tree) -> None:
    tree.edit(BODY, "with SPARK_Mode", "--  with SPARK_Mode\n")
    tree.refuses(f"without SPARK_Mode: {BODY}")


def test_a_unit_is_not_analysed(tree: Tree) -> None:
    units = f"{RECORD}/units.txt"
    tree.edit(units, "used 2 of 3", "used 3 of 3")
    tree.refuses(f"{units} differs from the sources: +used whole, -used part")
    tree.edit(units, "whole 3 of 3\n", "")
    tree.refuses("-whole whole")


def test_readme_has_another_total(tree: Tree) -> None:
    tree.edit("README.md", "6 checks", "7 checks")
    for part in ("record", "standing"):
        tree.refuses("the table in README.md has another number or commit", part)
