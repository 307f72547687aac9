#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The manual, its copy in docs, and completion, which are made of the command line's own description.
# Usage: description_test.sh PATH_OF_CAGEPROOF PATH_OF_DOCS
documents=$2
. "$(dirname "$0")/support.sh"

# The page is one that man takes without a word, and has every command and option.
"$cageproof" man >cageproof.1 || fail man
if command -v groff >/dev/null; then
  groff -man -ww -Tutf8 cageproof.1 >page.txt 2>warnings || fail 'groff fails'
  [ ! -s warnings ] || fail "groff: $(head -n 3 warnings)"
fi
if command -v mandoc >/dev/null; then mandoc -Tlint -W warning cageproof.1 >warnings || fail "mandoc: $(head -n 3 warnings)"; fi
grep -q '^\.TH CAGEPROOF 1 ' cageproof.1 || fail 'no title'
for section in NAME SYNOPSIS COMMANDS 'EXIT STATUS' SIGNALS ENVIRONMENT; do grep -qx "\.SH $section" cageproof.1 || fail "no section $section"; done
commands=$("$cageproof" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<<"$commands")" -ge 16 ] || fail "commands: $commands"
"$cageproof" completion bash >completion || fail 'completion bash'
for command in $commands; do
  grep -qx "\.SS $command" cageproof.1 || fail "no $command in the manual"
  for option in $("$cageproof" "$command" --help | grep -oE '^  (-h,)?--[a-z,-]+' | tr ',' '\n' | grep -oE -- '--[a-z-]+'); do
    grep -qF -- "\\fB${option//-/\\-}\\fR" cageproof.1 || fail "no $option of $command in the manual"
    grep -qF -- "$option" completion || fail "no $option of $command in the completion"
  done
done

# Its copy.
"$cageproof" man --markdown | diff - "$documents/command_line.md" >difference ||
  fail "docs/command_line.md is old, \`cageproof man --markdown --out docs/command_line.md\` makes it: $(head -n 5 difference)"

# Completion in bash.
bash -n completion || fail 'bash does not take its completion'
# shellcheck disable=SC1091
. ./completion
# completes WORDS... : OFFERED...
completes() {
  COMP_WORDS=()
  while [ "$1" != : ]; do COMP_WORDS+=("$1"); shift; done
  shift
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _cageproof
  [ "${COMPREPLY[*]}" = "$*" ] || fail "completion of ${COMP_WORDS[*]}: ${COMPREPLY[*]}, not $*"
}
mkdir folder && touch folder/file file.obj
completes cageproof veri : verify
completes cageproof help comp : compare completion
completes cageproof --v : --version
completes cageproof verify --re : --regimes --regime --resume
completes cageproof verify --suite '' : quick standard full
completes cageproof verify --suite = st : standard
completes cageproof coordinates --kind=gr : --kind=green
completes cageproof field --compare gau,clo : gau,closed_form
completes cageproof verify --regimes near-f : near-face
completes cageproof verify --regimes far,near-f : far,near-face
completes cageproof verify --formulas segment.winding_angle,triangle.sol : segment.winding_angle,triangle.solid_angle
completes cageproof verify --out fo : folder
completes cageproof eval --formula triangle.sol : triangle.solid_angle
completes cageproof eval --evaluation clo : closed_form
completes cageproof eval --scalar mp1 : mp100
completes cageproof coordinates --kind gr : green
completes cageproof coordinates --cage twi : twisted-bar
completes cageproof coordinates --cage fil : file.obj
completes cageproof deform --method gre : green
completes cageproof hunt --check tru : truth
completes cageproof replay fi : file.obj
completes cageproof report fo : folder
completes cageproof list near-fa : near-face
completes cageproof completion '' : bash zsh fish
completes cageproof bench --samples '' :

# The other shells', where they are.
for shell in zsh fish; do
  "$cageproof" completion $shell >$shell.txt || fail "completion $shell"
  if command -v $shell >/dev/null; then $shell -n $shell.txt || fail "$shell does not take its completion"; fi
done
refuses_to completion "none of bash, zsh, fish" -- tcsh
refuses_to man nowhere -- --out nowhere/page

[ $failures -eq 0 ] && echo "manual and completion say what there is"
exit $failures
