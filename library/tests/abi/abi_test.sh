#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The C interface as programs were compiled against it: abidiff compares it with library/tests/abi/cageproof.abi, where names, signatures, structures and the
# library's name are kept. Any change fails; --update writes the description anew. Usage: abi_test.sh LIBRARY C_COMPILER [--update].
# Exit 77, for CTest's "skipped", without abidiff (on Debian: abigail-tools) or on another processor than x86-64.
#
# A release has no debugging symbols. Signatures are therefore read from stubs of what the header declares: C++ refuses a definition of another signature, and
# the test library.shared compares the library's names with the header's.
set -u
library=$(readlink -f "$1") cc=$2 update=${3-}
here=$(dirname "$(readlink -f "$0")") && include=$(readlink -f "$here/../../include") exports=$(readlink -f "$here/../../exports.map")
description=$here/cageproof.abi
for tool in abidiff abidw; do
  command -v $tool >/dev/null || { echo "skipped: no $tool here (on Debian: apt-get install abigail-tools)" && exit 77; }
done
[[ $(uname -m) == x86_64 ]] || { echo "skipped: the description is of x86-64" && exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "FAILED: $*"
  exit 1
}

soname=$(readelf -d "$library" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
# stubs HEADER NAME: a library of that name whose functions do nothing, with debugging symbols.
stubs() {
  mkdir -p "$work/$2" && "$cc" -E -P -x c -std=c99 "$1" >"$work/$2/header.i" || return 1
  # Each declaration of a function becomes a definition.
  awk 'BEGIN {RS = ";"; ORS = ""}
    /cageproof_[a-z_]+[ \n]*\(/ && !/typedef/ {print $0 (/void[ \n]+cageproof_/ ? " {}" : " { return 0; }") "\n"; next}
    {print $0 ";"}' "$work/$2/header.i" >"$work/$2/stubs.c"
  (cd "$work/$2" && "$cc" -std=c99 -g -O0 -shared -fPIC -w "-Wl,--soname,$soname" "-Wl,--version-script=$exports" stubs.c -o libcageproof.so 2>&1 | head -n 5; exit "${PIPESTATUS[0]}")
}
stubs "$include/cageproof.h" now || fail "no stubs of cageproof.h"
symbols() { nm --dynamic --defined-only --with-symbol-versions "$1" | awk '{print $3}' | sort; }
diff <(symbols "$library") <(symbols "$work/now/libcageproof.so") || fail "the library has other symbols, or versions of them, than the header declares"
abi=$(awk '$2 == "CAGEPROOF_ABI_VERSION" {print $3}' "$include/cageproof.h")
[[ $soname == "libcageproof.so.$abi" ]] || fail "the library's name is $soname, and CAGEPROOF_ABI_VERSION is $abi"

if [[ $update == --update ]]; then
  abidw --no-show-locs --no-corpus-path --no-comp-dir-path "$work/now/libcageproof.so" >"$work/new" || fail "abidw"
  cp "$work/new" "$description" && echo "written: $description"
  exit
fi
abidiff "$description" "$work/now/libcageproof.so" >"$work/difference" || {
  code=$?
  cat "$work/difference"
  ((code & 8)) && fail "programs compiled before break: undo that, or raise CAGEPROOF_ABI_VERSION and SOVERSION, then run this with --update"
  fail "the interface changed: where programs compiled before go on, run this with --update; else raise CAGEPROOF_ABI_VERSION and SOVERSION first"
}

# Whether abidiff sees what breaks programs: in a copy of the header.
changed() {
  sed "$2" "$include/cageproof.h" >"$work/changed.h"
  cmp -s "$include/cageproof.h" "$work/changed.h" && fail "this test no longer changes anything: $1"
  stubs "$work/changed.h" changed || fail "no stubs: $1"
  abidiff "$description" "$work/changed/libcageproof.so" >"$work/difference" && fail "not noticed: $1"
  grep -q "$3" "$work/difference" || fail "another difference than '$3': $(cat "$work/difference")"
}
changed 'an argument has another type' '/cageproof_list(/s/size_t size/int size/' "parameter 3 of type 'typedef size_t' changed"
changed 'a function is gone' '/cageproof_abi_version(void)/d' 'int cageproof_abi_version()'
changed 'a function returns something else' 's/const char\* cageproof_version/int cageproof_version/' 'return type changed'
changed 'a structure has one more member' 's/^\(typedef struct cageproof_option {\)/\1 int more;/' 'type size changed'
echo "the interface is that of $(basename "$description"), $(symbols "$library" | wc -l) symbols as $soname"
