#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""vcpkg.json and conanfile.py name what CMake finds and sources include, part by part, and the project's version. Usage: packages_test.py LIBRARY CC

Neither vcpkg nor Conan is in Debian: the recipe is run with a stand-in for the module conan, to the package that a C program links."""

import fnmatch
import json
import re
import shutil
import subprocess
import sys
import tempfile
import types
from pathlib import Path

import jsonschema

PROJECT = Path(__file__).resolve().parents[3]
LIBRARY_ROOMS = ("core", "closed_form", "adaptive_qmvc", "solved", "deformation", "fast", "library")
LISTING = (PROJECT / "CMakeLists.txt").read_text()
VERSION = re.search(r"project\(cageproof VERSION (\S+)", LISTING).group(1)

# What CMake or a source calls it: vcpkg's port, Conan's package. None: not in that registry, which the files say.
NAMES = {
    "Eigen3": ("eigen3", "eigen"), "Boost": ("boost-config", "boost"), "fmt": ("fmt", "fmt"), "TBB": ("tbb", "onetbb"),
    "NLopt": ("nlopt", "nlopt"), "mpfr": ("mpfr", "mpfr"), "gmp": ("gmp", "gmp"), "CGAL/version.h": ("cgal", "cgal"),
    "Random123": ("random123", None), "nlohmann_json": ("nlohmann-json",), "CLI11": ("cli11",), "LibXml2": ("libxml2",), "VTK": ("vtk",),
    "flint": ("flint",), "arb": ("arb",), "arb.h": ("arb",), "GTest": ("gtest",), "LibArchive": ("libarchive",), "ZLIB": ("zlib",), "gd": ("libgd",),
    "gd.h": ("libgd",), "cairo": ("cairo",), "cairo.h": ("cairo",), "xtensor/xnpy.hpp": ("xtensor",), "kainjow/mustache.hpp": (None,),
    "benchmark": ("benchmark",), "sleef": ("sleef",), "sleef.h": ("sleef",),
}  # fmt: skip

DEPENDENCIES = {"type": "array", "uniqueItems": True, "items": {"type": "string", "pattern": "^[a-z0-9]+(-[a-z0-9]+)*$"}}
# The part of vcpkg's schema that is used here; it knows no other members.
SCHEMA = {
    "type": "object",
    "required": ["name", "version", "description", "license", "dependencies"],
    "properties": {
        "$schema": {"type": "string"},
        "$comment": {"type": "string"},
        "name": {"const": "cageproof"},
        "version": {"type": "string", "pattern": r"^\d+(\.\d+)*$"},
        "description": {"type": "string"},
        "license": {"type": "string"},
        "supports": {"type": "string"},
        "dependencies": DEPENDENCIES,
        "features": {
            "type": "object",
            "propertyNames": {"pattern": "^[a-z0-9]+(-[a-z0-9]+)*$"},
            "additionalProperties": {
                "type": "object",
                "required": ["description"],
                "properties": {"description": {"type": "string"}, "dependencies": DEPENDENCIES},
                "additionalProperties": False,
            },
        },
    },
    "additionalProperties": False,
}


def found_by(text):
    """Names in find_package, find_library and find_path, with the least version of packages."""
    text = re.sub(r"#.*", "", text)
    found = {name: version for name, version in re.findall(r"find_package\((\w+)(?: ([\d.]+))?", text)}
    for names in re.findall(r"find_(?:library|path)\(\w+ (?:NAMES )?([^)]*)\)", text):
        known = [word for word in names.split() if word in NAMES]
        assert known, f"none of '{names}' is known to this test: name it in NAMES, vcpkg.json and conanfile.py"
        found[known[0]] = ""
    return found


def text_of(*files):
    return "\n".join((PROJECT / file).read_text() for file in files)


def parts():
    """By part, what CMake finds."""
    library, everything = LISTING.split("set(CMAKE_EXPORT_COMPILE_COMMANDS", 1)
    core, readers = text_of("core/CMakeLists.txt").split("if(CAGEPROOF_LIBRARY_ONLY)", 1)
    room = {r.parent.name: r.read_text() for r in PROJECT.glob("*/CMakeLists.txt")}
    rest = [text for name, text in room.items() if name not in (*LIBRARY_ROOMS, "benchmarks")]
    of_library = found_by("\n".join([library, core, text_of("library/shared.cmake", "cmake/cageproofNumbers.cmake"), *(room[r] for r in LIBRARY_ROOMS[1:])]))
    of_program = found_by("\n".join([everything, readers, *rest]))
    return {
        "library": of_library,
        "program": {k: v for k, v in of_program.items() if k != "GTest" and k not in of_library},
        "tests": {k: v for k, v in of_program.items() if k == "GTest"},
        "benchmarks": found_by(room["benchmarks"]),
    }


def included(words):
    """What the library's sources include of these, one name per match."""
    sources = [f for r in LIBRARY_ROOMS for f in (PROJECT / r).rglob("*") if f.suffix in (".h", ".cpp") and "/tests/" not in str(f)]
    pattern = re.compile(rf"#include <({words})", re.M)
    return {m for file in sources for m in pattern.findall(file.read_text())}


def check_vcpkg(by_part):
    manifest = json.loads((PROJECT / "vcpkg.json").read_text())
    jsonschema.validate(manifest, SCHEMA)
    assert manifest["version"] == VERSION, f"vcpkg.json says {manifest['version']}, CMakeLists.txt {VERSION}"
    boost = {"boost-" + m.removeprefix("boost/") for m in included(r"boost/[a-z_]+")}
    wanted = {part: {NAMES[name][0] for name in names} - {None} for part, names in by_part.items()}
    wanted["library"] |= boost | {NAMES[name][0] for name in included("Random123")}
    assert set(manifest["features"]) == set(by_part) - {"library"}
    for part, ports in wanted.items():
        given = manifest["dependencies"] if part == "library" else manifest["features"][part]["dependencies"]
        assert given == sorted(given), f"vcpkg.json, {part}: sort the names"
        assert set(given) == ports, f"vcpkg.json, {part}: differs by {sorted(set(given) ^ ports)}"
    missing = {name for names in by_part.values() for name in names if NAMES[name][0] is None}
    assert missing == {"kainjow/mustache.hpp"} and "Mustache" in manifest["features"]["program"]["description"]


def stand_in(asked):
    """The part of the module conan that the recipe uses."""

    class ConanFile:
        def requires(self, reference, **_):
            asked["requires"].append(reference)

    class Apt:
        def __init__(self, _):
            pass

        def install(self, names):
            asked["apt"] += names

    class Tool:
        def __init__(self, _):
            self.cache_variables = {}

        def generate(self):
            asked["variables"].update(self.cache_variables)

        def configure(self):
            asked["steps"].append("configure")

        def build(self, target):
            asked["steps"].append(target)

    def copy(_, pattern, src, dst):
        taken = [f for f in Path(src).iterdir() if fnmatch.fnmatch(f.name, pattern)]
        assert taken, f"conanfile.py: no {pattern} in {src}"
        Path(dst).mkdir(parents=True, exist_ok=True)
        for file in taken:
            shutil.copy(file, dst, follow_symlinks=False)

    modules = {
        "conan": {"ConanFile": ConanFile},
        "conan.tools": {},
        "conan.tools.cmake": {"CMake": Tool, "CMakeDeps": Tool, "CMakeToolchain": Tool, "cmake_layout": lambda _: None},
        "conan.tools.files": {"copy": copy, "load": lambda _, file: Path(file).read_text()},
        "conan.tools.system": {},
        "conan.tools.system.package_manager": {"Apt": Apt},
    }
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        sys.modules[name].__dict__.update(members)


def check_conan(by_part, library, compiler):
    asked = {"requires": [], "apt": [], "variables": {}, "steps": []}
    stand_in(asked)
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(PROJECT))
    from conanfile import Cageproof

    # Without the packages that have options, which are CMake's.
    spare = Cageproof()
    spare.options = types.SimpleNamespace(**dict.fromkeys(Cageproof.options, False))
    spare.requirements()
    spare.generate()
    assert {reference.split("/")[0] for reference in asked["requires"]} == {"boost", "cgal", "eigen", "fmt"}
    off = {f"CAGEPROOF_{name.upper()}": False for name in Cageproof.options}
    assert asked["variables"] == {"CAGEPROOF_LIBRARY_ONLY": True, **off} and all(f"option({name} " in LISTING for name in off)
    asked["requires"].clear()
    asked["variables"].clear()
    recipe = Cageproof()
    recipe.options = types.SimpleNamespace(**{name: Cageproof.default_options[name] for name in Cageproof.options})
    recipe.recipe_folder = recipe.source_folder = str(PROJECT)
    recipe.set_version()
    assert recipe.version == VERSION
    recipe.requirements()
    recipe.system_requirements()
    recipe.generate()
    given = dict(re.fullmatch(r"([a-z0-9]+)/\[>=([\d.]+) <\d+\]", reference).groups() for reference in asked["requires"])
    wanted = {NAMES[name][1]: least for name, least in by_part["library"].items()}
    assert set(given) == set(wanted), f"conanfile.py: differs by {sorted(set(given) ^ set(wanted))}"
    for name, least in wanted.items():
        assert not least or given[name] == least, f"conanfile.py: {name} from {given[name]}, and CMake wants {least}"
    assert asked["apt"] == ["librandom123-dev"] and included("Random123")
    assert asked["variables"] == {"CAGEPROOF_LIBRARY_ONLY": True, **dict.fromkeys(off, True)}
    for pattern in recipe.exports_sources:
        assert list(PROJECT.glob(pattern)), f"conanfile.py: no file is {pattern}"
    assert {p.split("/")[0] for p in recipe.exports_sources if p.endswith("/*")} == {*LIBRARY_ROOMS, "cmake"}
    recipe.build()
    assert asked["steps"] == ["configure", "cageproof_shared"] and f"add_library({asked['steps'][1]} " in text_of("library/shared.cmake")
    with tempfile.TemporaryDirectory() as folder:
        recipe.package_folder, recipe.build_folder = folder, str(Path(library).parents[1])
        recipe.package()
        recipe.cpp_info = types.SimpleNamespace(set_property=lambda *_: None)
        recipe.package_info()
        source = f"{folder}/a.c"
        Path(source).write_text('#include <cageproof.h>\n#include <stdio.h>\nint main(void) { return puts(cageproof_version()) < 0; }\n')
        flags = [f"-I{folder}/include", f"-L{folder}/lib", f"-Wl,-rpath,{folder}/lib", *(f"-l{name}" for name in recipe.cpp_info.libs)]
        subprocess.run([compiler, "-std=c99", source, *flags, "-o", f"{folder}/a"], check=True)
        assert subprocess.run([f"{folder}/a"], capture_output=True, text=True, check=True).stdout.strip() == VERSION
        assert {f.name for f in Path(folder, "licenses").iterdir()} == {"LICENSE", "licences.md"}


if __name__ == "__main__":
    found = parts()
    check_vcpkg(found)
    check_conan(found, *sys.argv[1:])
    print("vcpkg.json and conanfile.py name what CMake finds: " + "; ".join(f"{part} {len(names)}" for part, names in found.items()))
