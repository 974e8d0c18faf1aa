#  SPDX-License-Identifier: GPL-3.0-or-later
"""What script/sbom says of bin/destijl and bin/destijl_monitor."""

import json
import os
import re
from pathlib import Path
from typing import Any

import pytest
from parties import ROOT, ran

PROGRAMS = [str(ROOT / "bin/destijl"), str(ROOT / "bin/destijl_monitor")]
IDENTIFIER = re.compile(r"SPDXRef-[A-Za-z0-9.-]+")
LICENCE = re.compile(
    r"NOASSERTION|(MIT|ISC|Zlib|PostgreSQL|CC0-1.0|Apache-2.0|MPL-(1.1|2.0)|"
    r"BSD-[23]-Clause|L?GPL-[0-9.]+-(only|or-later)|( (AND|OR) (?!$)))+"
)


def sbom(*arguments: str | Path) -> tuple[int, str]:
    at = os.environ | {"SOURCE_DATE_EPOCH": "0"}
    return ran(ROOT / "script/sbom", *arguments, env=at)


@pytest.fixture(scope="module")
def text() -> str:
    status, text = sbom(ROOT / "README.md", *PROGRAMS)
    assert status == 0, text
    return text


@pytest.fixture
def bill(text: str) -> Any:
    return json.loads(text)


def test_it_is_spdx(bill: Any) -> None:
    assert (bill["spdxVersion"], bill["dataLicense"]) == ("SPDX-2.3", "CC0-1.0")
    assert bill["creationInfo"]["created"] == "1970-01-01T00:00:00Z"
    assert bill["creationInfo"]["creators"]
    assert re.fullmatch(r"https://[^#]+", bill["documentNamespace"])
    own = [one["SPDXID"] for one in (bill, *bill["packages"], *bill["files"])]
    assert len(own) == len(set(own))
    assert all(IDENTIFIER.fullmatch(one) for one in own)
    for package in bill["packages"]:
        for key in ("name", "versionInfo", "downloadLocation", "supplier"):
            assert package[key]
        assert package["filesAnalyzed"] is False
        assert LICENCE.fullmatch(package["licenseDeclared"])
        assert LICENCE.fullmatch(package["licenseConcluded"])
    for relation in bill["relationships"]:
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= set(own)
    described = {
        relation["relatedSpdxElement"]
        for relation in bill["relationships"]
        if relation["relationshipType"] == "DESCRIBES"
    }
    assert described == {file["SPDXID"] for file in bill["files"]}


def test_the_run_time_is_linked_statically_and_dynamically(bill: Any) -> None:
    #  libgnat.a is in gnat-12, or from Debian 13 on in gnat-14-PROCESSOR
    found = [
        (
            relation["spdxElementId"].removeprefix("SPDXRef-File-"),
            relation["relationshipType"],
            re.findall(r"-Package-((?:lib)?gnat)-", relation["relatedSpdxElement"]),
        )
        for relation in bill["relationships"]
        if re.search(r"libgnat[-.]", relation.get("comment", ""))
    ]
    assert found == [
        ("destijl", "STATIC_LINK", ["gnat"]),
        ("destijl-monitor", "DYNAMIC_LINK", ["libgnat"]),
    ]


def test_licences_of_debian_are_read() -> None:
    _, text = sbom(ROOT / "README.md", ROOT / "bin/libdestijl_vision.so")
    packages = json.loads(text)["packages"]
    licences = {one["name"]: one["licenseDeclared"] for one in packages}
    assert licences["libdeflate0"] == "MIT"
    assert licences["libc6"] == "NOASSERTION"


def test_the_gateway_depends_on_python_and_aiohttp() -> None:
    status, text = sbom(ROOT / "README.md", ROOT / "bin/destijl_web")
    assert status == 0, text
    (file,) = json.loads(text)["files"]
    assert (file["fileName"], file["fileTypes"]) == ("./destijl_web", ["TEXT"])
    packages = {one["name"]: one for one in json.loads(text)["packages"]}
    _, installed = ran("dpkg-query", "-W", "-f=${Version}", "python3-aiohttp")
    assert packages["python3-aiohttp"]["versionInfo"] == installed
    names = " ".join(packages)
    for wanted in (
        r"python3\.\d+-minimal",
        r"libpython3\.\d+-stdlib",
        "libssl3",
        "python3-segno",
    ):
        assert re.search(wanted, names)
    (cause,) = re.findall(
        "Depends:.* python3-aiohttp .*", (ROOT / "debian/control").read_text()
    )
    least = re.findall(r"\(>= (.*)\)", cause)
    older = ("dpkg", "--compare-versions", "3.8.4-1+deb12u1", "lt", *least)
    assert ran(*older) == (0, "")


def test_the_same_bill_again(text: str) -> None:
    assert sbom(ROOT / "README.md", *PROGRAMS) == (0, text)


def test_what_is_no_program_is_refused() -> None:
    readme = ROOT / "README.md"
    assert sbom(readme, readme) == (1, f"sbom: {readme} is not linked with anything\n")


def test_a_tarball_that_is_none_has_no_index(tmp_path: Path) -> None:
    status, said = ran(
        ROOT / "script/local-index", ROOT / "README.md", tmp_path / "index"
    )
    assert status == 1 and "is no release" in said
