// SPDX-License-Identifier: MIT
#include "manual.h"

namespace cageproof::cli {

const std::vector<ManualSection>& manual_sections() {
  static const std::vector<ManualSection> sections{
      {"Names, globs and lists",
       {"`cageproof list` prints all names of formulas, evaluations, regimes, checks, kinds of coordinates, deformers "
        "and embedded cages.",
        "Options that take several names (values NAMES, FORMULAS, EVALUATIONS, REGIMES, CHECKS) have one grammar, in "
        "every command: names and globs with commas between. In a glob * stands for any characters, ? for one, [ab] "
        "for one of these; quote it, or the shell expands it. Each name must exist, and each glob must match a name; "
        "otherwise it is refused, with the name that may have been meant. An evaluation must be one of a formula that "
        "is asked for. A glob takes only those matches that exist for the element and order. Options that may repeat "
        "take lists as well.",
        "Families of rules have a number in their names: gauss-<N> with N from 1 to 256, line-<digits>. Any number in "
        "the range that `cageproof list --json` states is a name; globs match those that verification runs."},
       {{"list 'gauss-*,batched'", "which formulas and kinds of coordinates have these evaluations"},
        {"--regimes 'near-*,far'", "the regimes near-face, near-edge ..., and far"},
        {"--formulas '*.solid_angle,segment.*'", "the solid angles of all elements, and all formulas of segments"},
        {"--evaluations 'gauss-*,closed_form'", "the Gauss rules that verification runs, and the closed form"}}},
      {"Numbers",
       {"Whole numbers are decimal; 1e3 and 1000 are the same. Seeds are from 0 to 2^64 - 1. Numbers are finite, and "
        "their ranges stand with the options. Coordinates in JSON are decimal, or hexadecimal floats in strings "
        "(\"0x1.8p-3\"), which lose nothing."},
       {}},
      {"Exit status",
       {},
       {{"0", "all went well, and every promise was kept"},
        {"1",
         "a promise is broken (verify, merge, report, replay, hunt), reports differ (compare), a quad is not "
         "valid (quads), or --strict found points without usable coordinates, or outside the cage (verify)"},
        {"2",
         "the command line or the input is not understood, or a file cannot be read or written: one line on standard "
         "error says which and why, nothing is deleted, and no file is left unfinished; `eval` answers a line that it "
         "does not understand in its place, with `error`"},
        {"128 + n", "ended by signal n: 130 after SIGINT (Ctrl-C), 143 after SIGTERM"}}},
      {"Signals",
       {"SIGINT, SIGTERM, SIGHUP and SIGPIPE end the program by that signal, after it has removed what it was writing. "
        "Earlier files stay as they were, with one exception: `verify --out` over an earlier report. As soon as it "
        "starts to measure, it replaces the report's journal, so that a run that was stopped can be resumed (`verify "
        "--resume FOLDER`). It also renames summary.json.gz and summary.md to earlier.summary.json.gz and "
        "earlier.summary.md, so that nobody takes the earlier verdict for the new one. The earlier pages stay until "
        "the new ones are complete. Input that is refused before anything is measured (exit code 2) leaves the folder "
        "as it is."},
       {}},
      {"Files and folders that are written",
       {"Every file and folder is written next to its place, as .NAME.partial-PID-N@HOST, and renamed when it is "
        "complete. The next command that writes to the same place removes what a killed process (SIGKILL, loss of "
        "power) left there, but no file of a process that still runs. A symbolic link stays: its target is replaced, "
        "or made if it is a file that does not exist yet. Pipes, devices and /dev/stdout are written to. Empty values "
        "of options are refused.",
        "A folder is replaced only by the same kind of command: a folder of `verify` by verify, merge and report, one "
        "of `field` by field, and likewise for `bench --out` and `figures`. Every such folder holds .cageproof-files, "
        "the list of the files written. If a folder holds anything else, or is of another kind, the command refuses, "
        "and says what is in the way."},
       {}},
      {"Output",
       {"Results go to standard output; progress, remarks and warnings go to standard error. On a terminal progress is "
        "one line with the time that is left, estimated from what was done so far; elsewhere it is one line per "
        "minute, so that a run of seconds writes none. --quiet leaves out progress and remarks, but not results (such "
        "as broken promises), warnings and errors. The same options and seed give identical bytes, whatever --jobs is, "
        "except in objects named environment (times, machine, threads, commit)."},
       {}},
      {"Environment",
       {},
       {{"TMPDIR", "folder for files that are removed when the command ends; default: /tmp"},
        {"CAGEPROOF_PROGRESS", "seconds between lines of progress where standard error is no terminal; default: 60"},
        {"CAGEPROOF_SIMD",
         "the instruction set of batched coordinates and of closed forms of triangles far away: plain, avx2 or avx512; "
         "default: the widest that the processor "
         "has. "
         "Another name, or a set that the processor lacks, is refused"}}},
      {"Completion",
       {"Installed for bash, zsh and fish in their folders below PREFIX/share. Without an installation: `source "
        "<(cageproof completion bash)`."},
       {}}};
  return sections;
}

}  // namespace cageproof::cli
