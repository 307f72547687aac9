#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same 2,000 calls from Python, C and C++ give the same bits. Usage: calls_test.sh LIBRARY C_COMPILER CXX_COMPILER
set -eu
here=$(dirname "$(readlink -f "$0")") && root=$(readlink -f "$here/../../..")
CAGEPROOF_LIBRARY=$(readlink -f "$1")
export CAGEPROOF_LIBRARY PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/python
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
options=(-Wall -Wextra -pedantic -Werror -O1 -I "$root/library/include")
libraries=("$CAGEPROOF_LIBRARY" "-Wl,-rpath,$(dirname "$CAGEPROOF_LIBRARY")")
/usr/bin/python3 "$here/write_calls.py" "$work/calls"
"$2" -std=c99 "${options[@]}" "$here/calls.c" "${libraries[@]}" -o "$work/c"
"$work/c" "$work/calls"
"$3" -std=c++20 "${options[@]}" "$here/calls.cpp" "${libraries[@]}" -o "$work/cpp"
"$work/cpp" "$work/calls"
