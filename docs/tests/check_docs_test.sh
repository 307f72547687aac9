#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# check_docs_test.sh FOLDER: whether scripts/check_docs, with the programs in FOLDER, sees what is wrong on a page, names its line, and accepts what is right.
set -uo pipefail
check=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/scripts/check_docs
programs=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# page NAME: a page from standard input. expect NAME CODE WORD [OPTION...]: what check_docs says of it.
page() { cat >"$work/$1.md"; }
expect() {
  local name=$1 code=$2 word=$3
  shift 3
  "$check" --programs "$programs" "$@" "$work/$name.md" >"$work/said" 2>&1
  local got=$?
  if [[ $got -ne $code ]] || ! grep -qF -- "$word" "$work/said"; then
    printf 'FAILED: %s: exit %s, not %s, or no "%s" in:\n%s\n' "$name" "$got" "$code" "$word" "$(cat "$work/said")"
    failures=$((failures + 1))
  fi
}

page right <<'END'
    cageproof eval --formula triangle.solid_angle --evaluation closed_form <input.jsonl || echo 'exit 2'
<!-- output -->

    exit 2

<!-- file: words.txt -->

    one 1.25
    two

<!-- exit 3 -->

    cageproof --version >/dev/null
    cat words.txt; exit 3

<!-- output, within 1e-3 -->

    one 1.2501
    ...

```sh
echo "took 12 ms"
```
<!-- output, numbers vary -->
```
took 7 ms
```
<!-- long -->

    cageproof no-such-command

<!-- not run: there is no such program -->

    cageproof no-such-command
END
expect right 0 'right.md:1:'
expect right 1 'right.md:30: exit code 2, not 0: cageproof no-such-command' --long
expect right 0 'right.md:34: not run, there is no such program: cageproof no-such-command' --list

page failing <<'END'
A line.

    cageproof --version
    cageproof list \
      --no-such-option
END
expect failing 1 'failing.md:4: exit code 2, not 0'

page first_line <<'END'
    cageproof no-such-command
    true
END
expect first_line 1 'first_line.md:1: exit code 2, not 0: cageproof no-such-command'

page stale <<'END'
    cageproof --version
    echo 17
<!-- output -->

    ...
    18
END
expect stale 1 'stale.md:5: the program prints something else'

page number <<'END'
```sh
echo 1.25
```
<!-- output, within 1e-3 -->
```
1.26
```
END
expect number 1 'number.md:6: the program prints'

page dots <<'END'
```sh
echo "off by 1.25; see there"
```
<!-- output, within 1e-3 -->
```
off by 1.26; ...
```
END
expect dots 1 'dots.md:6: the program prints'
sed -i 's/1.26/1.2501/' "$work/dots.md"
expect dots 0 'dots.md:2:'

page misspelt <<'END'
<!-- long, very -->

    cageproof --version
END
expect misspelt 1 "no mark is 'long, very'"

page links <<'END'
# A heading, `twice`
[there](#a-heading-twice) [not there](#another), [page](no_such_page.md), `docs/no_such_page.md`, `core/src/no_such_source.cpp`, `library/no_such_header.h`,
`sovled/src/boundary.cpp`, `core/geometry/quad.cpp`, `quad/kernel.cpp`, `NAME/fields.vti`
END
expect links 1 'has no heading #another' --links
expect links 1 'no file no_such_page.md' --links
expect links 1 'no file `docs/no_such_page.md`' --links
expect links 1 'no file `core/src/no_such_source.cpp`' --links
expect links 1 'no file `library/no_such_header.h`' --links
# A misspelt room; a file whose room is right and whose folder is not.
expect links 1 'no file `sovled/src/boundary.cpp`' --links
expect links 1 'no file `core/geometry/quad.cpp`' --links
grep -qE 'quad/kernel.cpp|fields.vti' "$work/said" && { echo 'FAILED: the end of a path and a report'"'"'s file are taken for broken'; failures=$((failures + 1)); }
grep -q 'heading #a-heading-twice' "$work/said" && { echo 'FAILED: a heading that exists is not found'; failures=$((failures + 1)); }

page excerpt <<'END'
<!-- shown: LICENSE -->
```
No licence at all
```
END
expect excerpt 1 'this is not what stands in LICENSE'

[[ $failures -eq 0 ]] && echo 'check_docs finds what is wrong, and nothing else.'
exit $((failures > 0))
