# SPDX-License-Identifier: MIT
"""The manifest is what Blender 4.2's schema 1.0.0 takes, and says what the project says; the zip holds what both Blenders look for."""

import ast
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
ADD_ON = PROJECT / "blender/cageproof_blender"
VERSION = re.search(r"project\(cageproof VERSION (\S+)", (PROJECT / "CMakeLists.txt").read_text()).group(1)

REQUIRED = {"schema_version", "id", "version", "name", "tagline", "maintainer", "type", "blender_version_min", "license"}
OPTIONAL = {"website", "tags", "blender_version_max", "copyright", "platforms", "wheels", "permissions", "build"}
PLATFORMS = {"windows-x64", "windows-arm64", "macos-x64", "macos-arm64", "linux-x64"}
# Tags of add-ons that Blender's platform knows.
TAGS = {
    "3D View", "Add Curve", "Add Mesh", "Animation", "Bake", "Camera", "Compositing", "Development", "Game Engine", "Geometry Nodes",
    "Grease Pencil", "Import-Export", "Lighting", "Material", "Mesh", "Modeling", "Node", "Object", "Paint", "Physics", "Pipeline", "Render",
    "Rigging", "Scene", "Sculpt", "Sequencer", "System", "Text Editor", "Tracking", "User Interface", "UV",
}  # fmt: skip


def faults(m):
    """What schema 1.0.0 refuses."""
    found = [f"{key} is missing" for key in REQUIRED - m.keys()] + [f"{key} is unknown" for key in m.keys() - REQUIRED - OPTIONAL]
    texts = {key: m[key] for key in REQUIRED - {"license"} if key in m}
    found += [f"{key} is no text" for key, value in texts.items() if not isinstance(value, str) or not value.strip() or value != value.strip()]
    lists = {key: m[key] for key in ("license", "copyright", "tags", "platforms", "wheels") if key in m}
    found += [f"{key} is no list of texts" for key, v in lists.items() if not isinstance(v, list) or not v or not all(isinstance(x, str) for x in v)]
    if found:
        return found
    if m["schema_version"] != "1.0.0":
        found.append("schema_version")
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*", m["id"]):
        found.append("id is no name of Python without doubled or outer underscores")
    if not re.fullmatch(r"\d+\.\d+\.\d+([-+][0-9A-Za-z.+-]+)?", m["version"]):
        found.append("version")
    if m["type"] != "add-on":
        found.append("type")
    if not re.fullmatch(r"\d+\.\d+\.\d+", m["blender_version_min"]) or tuple(map(int, m["blender_version_min"].split("."))) < (4, 2, 0):
        found.append("blender_version_min")
    if len(m["tagline"]) > 64 or not (m["tagline"][-1].isalnum() or m["tagline"][-1] in ")]}"):
        found.append("tagline is longer than 64 or ends with punctuation")
    found += [f"license {x}" for x in m["license"] if not re.fullmatch(r"SPDX:[A-Za-z0-9.+-]+", x)]
    found += [f"copyright {x}" for x in m.get("copyright", []) if not re.fullmatch(r"\d{4}(-\d{4})? \S.*", x)]
    found += [f"tag {x}" for x in m.get("tags", []) if x not in TAGS]
    found += [f"platform {x}" for x in m.get("platforms", []) if x not in PLATFORMS]
    found += [f"wheel {x}" for x in m.get("wheels", []) if not re.fullmatch(r"\./wheels/[^-/]+-[^-]+(-\d[^-]*)?-[^-]+-[^-]+-[^-]+\.whl", x)]
    return found


@pytest.fixture(scope="module")
def manifest():
    return tomllib.loads((ADD_ON / "blender_manifest.toml").read_text())


def test_schema(manifest):
    assert faults(manifest) == []


@pytest.mark.parametrize(
    "key, value",
    [
        ("schema_version", "1.0"), ("id", "cage-proof"), ("id", "a__b"), ("version", "0.1"), ("version", 1), ("type", "addon"), ("tagline", "It ends."),
        ("tagline", "x" * 65), ("blender_version_min", "3.4.0"), ("license", "SPDX:MIT"), ("license", ["MIT"]), ("license", []), ("tags", ["Cages"]),
        ("platforms", ["linux"]), ("wheels", ["wheels\\a.whl"]), ("copyright", ["The authors"]), ("licence", ["SPDX:MIT"]), ("name", None),
    ],
)  # fmt: skip
def test_faults_are_found(manifest, key, value):
    broken = {k: v for k, v in {**manifest, key: value}.items() if v is not None}
    assert faults(broken)


def test_it_says_what_the_project_says(manifest):
    tree = ast.parse((ADD_ON / "__init__.py").read_text())
    info = next(ast.literal_eval(n.value) for n in tree.body if isinstance(n, ast.Assign) and n.targets[0].id == "bl_info")
    assert manifest["version"] == VERSION == ".".join(map(str, info["version"]))
    assert manifest["wheels"] == [f"./wheels/cageproof-{VERSION}-py3-none-linux_x86_64.whl"]
    assert (manifest["name"], manifest["tagline"], manifest["id"]) == (info["name"], info["description"], ADD_ON.name)
    assert info["category"] in manifest["tags"] and info["blender"] <= (3, 4, 0)
    # What Blender's platform asks of add-ons; and what the files are under.
    assert manifest["license"] == ["SPDX:GPL-3.0-or-later", "SPDX:MIT"]
    assert all("SPDX-License-Identifier: MIT" in file.read_text() for file in ADD_ON.glob("*.py"))


def test_zip(manifest, tmp_path):
    wheel = tmp_path / Path(manifest["wheels"][0]).name
    wheel.write_bytes(b"a wheel")
    build = [sys.executable, PROJECT / "blender/build.py", "--out", tmp_path]
    done = subprocess.run([*build, "--wheel", wheel], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(done.stdout.strip()) as packed:
        names = packed.namelist()
        assert tomllib.loads(packed.read("cageproof_blender/blender_manifest.toml").decode()) == manifest
        assert packed.read(f"cageproof_blender/wheels/{wheel.name}") == b"a wheel"
    assert {name.split("/")[0] for name in names} == {"cageproof_blender"}
    assert {f"cageproof_blender/{f.name}" for f in ADD_ON.glob("*.py")} | {"cageproof_blender/LICENSE"} <= set(names)
    other = wheel.rename(wheel.with_name("cageproof-9.9.9-py3-none-linux_x86_64.whl"))
    done = subprocess.run([*build, "--wheel", other], capture_output=True, text=True)
    assert done.returncode == 2 and "make them the same" in done.stderr


def test_the_real_wheel(manifest, tmp_path):
    """The package stands at the root of the wheel that is built, with its library."""
    done = subprocess.run([sys.executable, PROJECT / "blender/build.py", "--out", tmp_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    with zipfile.ZipFile(done.stdout.strip()) as packed, packed.open("cageproof_blender" + manifest["wheels"][0][1:]) as wheel:
        names = zipfile.ZipFile(wheel).namelist()
    assert {f"cageproof/{name}" for name in ("__init__.py", "libcageproof.so", "LICENSE", "licences.md")} <= set(names)
    assert not [name for name in names if ".data/" in name]


def test_the_wheel_is_found(tmp_path):
    """Blender before 4.2 does not install it: the add-on unpacks it once, beside itself."""
    (tmp_path / "wheels").mkdir()
    (tmp_path / "wheel.py").write_text((ADD_ON / "wheel.py").read_text())

    def imports():
        code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import wheel; wheel.find(); import cageproof; print(cageproof.__file__)"
        return subprocess.run([sys.executable, "-I", "-S", "-B", "-c", code], capture_output=True, text=True)

    assert "no package cageproof, and no wheel in" in imports().stderr
    name = "cageproof-0.1.0-py3-none-linux_x86_64"
    with zipfile.ZipFile(tmp_path / f"wheels/{name}.whl", "w") as packed:
        packed.writestr("cageproof/__init__.py", "")
    for _ in range(2):
        assert imports().stdout.strip() == str(tmp_path / "wheels" / name / "cageproof/__init__.py")
    assert {f.name for f in (tmp_path / "wheels").iterdir()} == {name, f"{name}.whl"}
