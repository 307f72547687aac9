# SPDX-License-Identifier: MIT
"""Runs a page's commands, one block after the other, in a fresh folder with the files of docs/examples."""

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

from docs_checks.compare import difference, same
from docs_checks.page import Block, blocks, shown_name

# Seconds a block may take: in a build with sanitizers commands take ten times as long.
QUICK_LIMIT, LONG_LIMIT = 600, 24 * 3600


def prepare(folder: Path, programs: Path, root: Path, long: bool) -> dict[str, str]:
    """Puts the examples into the folder, and ./verify, ./test, scripts/ and judge/ as a clone has them; returns the environment of the commands."""
    for example in (root / "docs/examples").iterdir():
        shutil.copytree(example, folder / example.name) if example.is_dir() else shutil.copy(example, folder)
    (folder / "docs").mkdir()
    (folder / "docs/examples").symlink_to(folder)
    for name in ("verify", "test", "scripts", "judge"):
        if name == "verify" and not long:
            # The program that is there, without a build.
            (folder / name).write_text('#!/bin/sh\nexec cageproof verify "$@"\n')
            (folder / name).chmod(0o755)
        else:
            (folder / name).symlink_to(root / name)
    environment = dict(os.environ, PATH=f"{programs}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
    return environment


def run_block(block: Block, folder: Path, environment: dict[str, str], limit: float) -> tuple[int, str, str, int]:
    """Runs it; returns exit code, what was printed on both streams, and the page's line of the command that failed."""
    script = folder.parent / "block.sh"
    failed_at = folder.parent / "failed_at"
    failed_at.write_text(str(block.line))
    # The shell counts the page's lines: what it says of line n is said of the page.
    preamble = f"set -eE -o pipefail; trap 'printf %s \"$LINENO\" >{failed_at}' ERR"
    # On the first line nothing stands before the block, so the preamble shares that line.
    before = "\n" * (block.line - 2) + preamble + "\n" if block.line > 1 else preamble + "; "
    script.write_text(before + block.text)
    process = subprocess.Popen(["bash", script], cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True, errors="replace", start_new_session=True)
    try:
        output, messages = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        output, messages = process.communicate()
        messages += f"\nstopped after {limit} s"
    return process.returncode, output, messages, int(failed_at.read_text())


def tail(text: str, count: int = 12) -> str:
    return "\n".join("    " + line for line in text.rstrip().splitlines()[-count:])


def check_page(page: Path, programs: Path, root: Path, long: bool, without: str) -> list[str]:
    """Runs the page's blocks that are not long (or all that may run at all) and do not need the program `without`, and says which; returns what is wrong."""
    wrong = []
    name = shown_name(page, root)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "folder"
        folder.mkdir()
        environment = prepare(folder, programs, root, long)
        printed: dict[str, str] | None = None  # by the last block that ran
        for block in blocks(page):
            if block.file:
                (folder / block.file).parent.mkdir(parents=True, exist_ok=True)
                (folder / block.file).write_text(block.text)
            elif block.shown:
                if block.text.strip() not in (root / block.shown).read_text():
                    wrong.append(f"{name}:{block.line}: this is not what stands in {block.shown}")
            elif block.stream:
                if printed is None:
                    continue
                said, got = block.lines, printed[block.stream].rstrip("\n").splitlines()
                if not same(said, got, block.numbers):
                    wrong.append(f"{name}:{block.line}: the program prints something else ({block.stream}):\n{difference(said, got)}")
            elif block.is_command:
                printed = None
                if block.reason or (block.long and not long) or (without and without in block.text):
                    continue
                start = time.monotonic()
                code, output, messages, line = run_block(block, folder, environment, LONG_LIMIT if block.long else QUICK_LIMIT)
                print(f"{name}:{block.line}: {time.monotonic() - start:5.1f} s  {block.first_command()}", flush=True)
                if code != block.exit:
                    wrong.append(f"{name}:{line}: exit code {code}, not {block.exit}: {block.command_at(line)}\n{tail(output)}\n{tail(messages)}")
                else:
                    printed = {"output": output, "messages": messages}
    return wrong
