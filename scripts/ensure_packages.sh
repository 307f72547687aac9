#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# scripts/ensure_packages.sh [tests|arm]: installs the Debian packages that Cageproof needs, or its tests or the check on AArch64 as well, and the machine lacks; silent when nothing is missing.
# Says before what it installs and why. Exit 0: all there; 2: something is missing and could not be installed, or ParaView's package is in the way.
# Without dpkg it names the packages that are needed and leaves the verdict to CMake.
set -euo pipefail

# One package a line, then why.
packages() {
  cat <<'LIST'
g++                      C++20 compiler and library
cmake                    configures the build
ninja-build              runs the build
libeigen3-dev            vectors and matrices
libboost-dev             multiprecision numbers (Boost.Multiprecision), special constants, quadrature
libmpfr-dev              arithmetic with 50 to 200 digits, under Boost.Multiprecision
libgmp-dev               integers under MPFR
libcgal-dev              exact predicates: on which side of a plane or an edge a point lies; a test judges its mean value coordinates
libflint-arb-dev         ball arithmetic (Arb): enclosures that are proofs
libflint-dev             integers and polynomials under Arb
libvtk9-dev              reads PLY and VTP; writes fields for ParaView and pictures
libxml2-dev              reads SVG
libcli11-dev             command line
nlohmann-json3-dev       JSON in and out
libfmt-dev               text formatting
libnlopt-dev             least squares whose solution may not be negative, as a quadratic program (NLopt's SLSQP)
libtbb-dev               uses all cores (oneTBB)
librandom123-dev         counter-based random numbers: the same samples for any number of threads
libxtensor-dev           writes NumPy's .npy
libarchive-dev           writes ZIP files: NumPy's .npz
zlib1g-dev               packs what is long in a report
libkainjow-mustache-dev  template of the report's page
libgd-dev                small PNGs inside the report's page
libcairo2-dev            draws the papers' figures, without a display
gnuplot-nox              draws the curves of a report, without a display
fonts-dejavu-core        lettering of those curves
libgtest-dev             unit tests
clang-format             the formatting that CI asks for
libbenchmark-dev         benchmarks
libsleef-dev             arc tangents and logarithms on vectors, which the benchmarks take for a yardstick
LIST
}

# Not needed, but good to have: nothing fails without them.
helpful() {
  cat <<'LIST'
clang-16                 compiles all this in two thirds of the time that g++ takes
libclang-rt-16-dev       the sanitizers' runtime for clang-16
clang-tidy-16            what CI asks of changed sources
ccache                   keeps what was compiled, for the next time
LIST
}

say() { printf '%s\n' "$*" >&2; }

# Packages that only tests need: `scripts/ensure_packages.sh tests` installs these, too.
tests_alone() {
  cat <<'LIST'
openmpi-bin              starts four ranks that measure one run
python3                  runs the commands of README.md and docs/
python3-clang-16         reads sources for scripts/mutate, whose accounting is tested
python3-jsonschema       checks real output against docs/schemas
nodejs                   runs the checker of test vectors in JavaScript
python3-numpy            docs/apply.md's examples: what coordinates' files hold, and what is done with it
python3-pytest           runs the tests of the package for Python
python3-hypothesis       seeks counterexamples of what must hold for any cage, through that package
python3-pip              builds and installs that package
python3-setuptools       builds its wheel
python3-wheel            likewise
python3-venv             installs it in a folder of its own
abigail-tools            abidiff: whether programs compiled with an older cageproof.h still run
pkgconf                  the installed library, found by pkg-config
chromium                 opens the report's pages, without a display
python3-vtk9             looks at the picture of a field's page
LIST
}

# Packages that only scripts/check_neon.sh and `scripts/check_alone arm` need.
arm_alone() {
  cat <<'LIST'
g++-aarch64-linux-gnu    compiles for AArch64, and has its standard library, which clang-16 takes too
qemu-user-static         runs what was compiled for AArch64
LIST
}

with=${1-}
needed() {
  packages
  if [[ $with == tests ]]; then tests_alone; fi
  if [[ $with == arm ]]; then arm_alone; fi
}

if ! command -v dpkg-query >/dev/null; then
  say "Not a Debian system (no dpkg-query): Cageproof needs these, under your system's names:"
  needed | sed 's/^/  /' >&2
  say "Going on; CMake names what it does not find."
  exit 0
fi

# The names on standard input that are not installed.
missing_of() {
  local names installed
  mapfile -t names < <(awk '{print $1}')
  # dpkg-query fails when it does not know one of the names; its lines on the others still count.
  installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${names[@]}" 2>/dev/null |
    awk '$2 == "installed" {print $1}' || true)
  printf '%s\n' "${names[@]}" | grep --invert-match --line-regexp --fixed-strings --file=<(printf '%s\n' "$installed") || true
}

mapfile -t missing < <(needed | missing_of)

# Debian's python3-paraview conflicts with python3-vtk9, which libvtk9-dev depends on. apt-get refuses or removes one of them, so the user decides.
if [[ " ${missing[*]} " =~ ' '(libvtk9-dev|python3-vtk9)' ' && -z $(echo python3-paraview | missing_of) ]]; then
  say "python3-paraview is installed, and Debian's packages conflict: it excludes python3-vtk9, which Cageproof's libvtk9-dev needs."
  say "Nothing was installed, because only one of the two can be. ParaView's window program can stay, without its Python modules. Run as root:"
  say "  apt-get install -y --no-install-recommends libvtk9-dev python3-vtk9 python3-paraview-"
  say "then start again. docs/fields.md has other ways to keep ParaView and pvpython."
  exit 2
fi
mapfile -t wanted < <(helpful | missing_of)
((${#missing[@]} + ${#wanted[@]})) || exit 0

as_root=()
may_install=yes
if ((EUID != 0)); then
  as_root=(sudo)
  # Without a terminal sudo cannot ask for a password.
  { : </dev/tty; } 2>/dev/null || as_root=(sudo -n)
  if ! command -v sudo >/dev/null || ! "${as_root[@]}" true </dev/null 2>/dev/null; then may_install=; fi
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 "$@" </dev/null >>"$log" 2>&1
}

install_command() { printf 'apt-get install -y --no-install-recommends %s' "$*"; }

if ((${#missing[@]})); then
  say "Cageproof needs ${#missing[@]} Debian package(s) that this machine lacks:"
  needed | awk -v missing=" ${missing[*]} " 'index(missing, " " $1 " ") {print "  " $0}' >&2
  if [[ -z $may_install ]]; then
    say "They cannot be installed from here: neither root nor sudo. Ask for this to be run as root, then start again:"
    say "  $(install_command "${missing[@]}")"
    exit 2
  fi
  say "Installing them now (a minute or two): ${as_root[*]:+${as_root[*]} }$(install_command "${missing[@]}")"
  if ! apt install -y --no-install-recommends "${missing[@]}"; then
    # Empty or stale package lists are the usual reason.
    say "Not installable yet; refreshing the package lists (apt-get update) and trying again."
    if ! { apt update && apt install -y --no-install-recommends "${missing[@]}"; }; then
      cat "$log" >&2
      say "The packages could not be installed; the reason is above. The command was:"
      say "  $(install_command "${missing[@]}")"
      exit 2
    fi
  fi
  say "Installed."
fi

# Without a word where they cannot be had: it would come with every build.
if ((${#wanted[@]})) && [[ -n $may_install ]]; then
  say "Installing what is helpful, not needed: ${wanted[*]}"
  apt install -y --no-install-recommends "${wanted[@]}" || { apt update && apt install -y --no-install-recommends "${wanted[@]}"; } ||
    say "They could not be installed; going on without them."
fi
