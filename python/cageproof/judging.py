# SPDX-License-Identifier: MIT
"""Judges a Python callable by the program `cageproof` (docs/judge.md), which asks it through a relay and a socket."""

import contextlib
import faulthandler
import json
import os
import select
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from ._library import Error, names
from .potentials import formula

_RELAY = Path(__file__).resolve().with_name("_relay.py")
_BUILT = Path(__file__).resolve().parents[2] / "build/release/bin/cageproof"


def _program(given: Optional[str]) -> str:
    found = given or os.environ.get("CAGEPROOF_PROGRAM") or shutil.which("cageproof") or (str(_BUILT) if _BUILT.is_file() else "")
    if not found or not shutil.which(found):
        said = f"'{found}' is no program" if found else "no program `cageproof` is installed"
        raise Error(f"{said}: build and install it (docs/library.md), or name it by program= or CAGEPROOF_PROGRAM")
    return found


class _Answers:
    """Answers lines of the protocol by the callable: those of a formula."""

    def __init__(self, name: str, f: Callable, order: int):
        about = f"{getattr(f, '__module__', '')}.{getattr(f, '__qualname__', type(f).__name__)}"
        self.f, self.order = f, order
        self.description = {"formulas": {name: order}, "about": about}

    def __call__(self, query: Dict[str, Any]) -> Dict[str, Any]:
        if "describe" in query:
            return self.description
        try:
            return self.answer(query)
        except NotImplementedError as error:
            return {"error": str(error) or "not implemented"}

    def answer(self, query: Dict[str, Any]) -> Dict[str, Any]:
        shape, parameters = formula(query["formula"]), {name: float(_numbers(x)) for name, x in query.get("parameters", {}).items()}
        try:
            given = self.f(_numbers(query["element"]), _numbers(query["point"]), **parameters)
        except ArithmeticError:
            given = [np.full(shape.shape + (shape.dimension,) * o, np.nan) for o in range(self.order + 1)]
            given = given if self.order else given[0]
        arrays = given if self.order else (given,)
        words = ("value", "gradient", "hessian")
        return {words[o]: _texts(np.asarray(arrays[o], float).ravel()) for o in range(query["order"] + 1)}

    def serve(self, connection: socket.socket) -> None:
        """Until the relay goes away. Any other error of the callable is told to the relay, which ends by it."""
        with connection, connection.makefile("rb") as stream, contextlib.suppress(OSError):
            for line in stream:
                try:
                    answer = json.dumps(self(json.loads(line)))
                except Exception as error:
                    answer = f"!{type(error).__name__}: {error}".replace("\n", " ")
                connection.sendall(answer.encode() + b"\n")


class _CageAnswers(_Answers):
    """Those of whole cages."""

    def answer(self, query: Dict[str, Any]) -> Dict[str, Any]:
        points = _numbers(query["points"])
        try:
            given = np.asarray(self.f(_numbers(query["vertices"]), np.array(query["faces"], np.int32), points), float)
        except ArithmeticError:
            given = np.full((len(points), len(query["vertices"])), np.nan)
        return {"coordinates": [_texts(row) for row in np.atleast_2d(given)]}


def _numbers(nested: Any) -> np.ndarray:
    """Coordinates come as JSON's numbers, or as text: decimal, hexadecimal, "nan", "inf"."""

    def number(x: Any) -> Any:
        if isinstance(x, list):
            return [number(y) for y in x]
        return float.fromhex(x) if isinstance(x, str) and "x" in x.lower() else float(x)

    return np.array(number(nested))


def _texts(numbers: np.ndarray) -> List[Any]:
    """As JSON has them, which knows neither NaN nor infinity."""
    return [x if np.isfinite(x) else str(x) for x in numbers.tolist()]


class _Children:
    """One process per relay, which forgets with it what the callable kept; ended when the relay goes away, also in an endless loop."""

    def __init__(self, answers: _Answers, poll: Any):
        self.answers, self.poll = answers, poll
        self.of: Dict[int, Tuple[int, socket.socket]] = {}
        self.pids: Dict[int, int] = {}

    def start(self, connection: socket.socket) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        child = os.fork()
        if child == 0:
            try:
                faulthandler.disable()  # the crash is reported by `judge`
                # A relay sees the end of its own process only if no other holds the connection.
                for _, other in self.of.values():
                    other.close()
                self.answers.serve(connection)
                sys.stdout.flush()
            finally:
                os._exit(0)
        self.of[connection.fileno()] = (child, connection)
        self.poll.register(connection, select.POLLRDHUP)
        pid = os.pidfd_open(child)
        self.pids[pid] = connection.fileno()
        self.poll.register(pid, select.POLLIN)

    def end(self, descriptor: int) -> None:
        """By the connection's descriptor, or the process's own."""
        descriptor = self.pids.get(descriptor, descriptor)
        if descriptor not in self.of:
            return
        child, connection = self.of.pop(descriptor)
        pid = next(p for p, d in self.pids.items() if d == descriptor)
        self.poll.unregister(pid)
        self.poll.unregister(connection)
        del self.pids[pid]
        os.close(pid)
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        connection.close()

    def end_all(self) -> None:
        for descriptor in list(self.of):
            self.end(descriptor)


def _run(command: list, listening: socket.socket, answers: _Answers, isolate: bool) -> subprocess.CompletedProcess:
    """Runs the program, and serves its relays meanwhile."""
    poll = select.poll()
    children = _Children(answers, poll)
    with tempfile.TemporaryFile("w+") as log, subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=log) as process:
        try:
            poll.register(listening, select.POLLIN)
            while process.poll() is None:
                # Ends first, so that a new connection is not taken for one that ended and had its number.
                for descriptor, _ in sorted(poll.poll(50), key=lambda event: event[0] == listening.fileno()):
                    if descriptor != listening.fileno():
                        children.end(descriptor)
                        continue
                    connection, _ = listening.accept()
                    if isolate:
                        children.start(connection)
                    else:
                        threading.Thread(target=answers.serve, args=(connection,), daemon=True).start()
        finally:
            process.kill()
            children.end_all()
        process.wait()
        log.seek(0)
        return subprocess.CompletedProcess(command, process.returncode, None, log.read())


def judge(
    name: str,
    f: Callable,
    order: int = 0,
    samples: int = 200,
    regimes: str = "*",
    seed: int = 1,
    promise: Optional[float] = None,
    measure: str = "relative",
    seconds: float = 10,
    isolate: bool = True,
    program: Optional[str] = None,
    dimension: int = 3,
) -> Dict[str, Any]:
    """The certificate of `cageproof judge` (docs/judge.md, docs/schemas) for a callable, as a dict: "verdict" is "clean" unless a
    defect was found or the promise broken; "findings" says what, where and with which input.

    f(element, point) of arrays (corners, dimension) and (dimension,) gives the formula's value, of the shape of
    `formula(name).shape`; with order=1 or 2 a tuple of value, gradient and Hessian by the point, as `evaluate` does. Parameters
    of the formula ("nu") come as keywords. NotImplementedError declines an input, ArithmeticError counts as NaN; any other
    exception is a finding.

    name may also be a kind of coordinates ("mean_value", "green"), of whole cages of triangles: f(vertices, faces, points) of arrays
    (n, 3), (m, 3) and (k, 3) gives one row of coordinates per point, those of vertices before those of faces. With dimension=2 cages
    are polygons in the plane, faces their segments, and the arrays (n, 2), (m, 2) and (k, 2).

    samples, regimes, seed, promise, measure, seconds: as of the command. isolate: f runs in forked copies of this process, so that
    crashes, endless loops and kept state are found; without, in a thread of it. program: the file of `cageproof`; else
    CAGEPROOF_PROGRAM, the one on the path, or of the project's build. Raises Error for bad arguments. On Linux only."""
    if not callable(f):
        raise Error("f is no function")
    if order not in (0, 1, 2):
        raise Error(f"order {order} is none of 0, 1, 2")
    kind = name in names("kinds")
    if kind and order:
        raise Error(f"{name} is a kind of coordinates: only values (order 0) are judged")
    if dimension not in (2, 3) or (dimension == 2 and not kind):
        raise Error(f"dimension {dimension}: 2 or 3 for a kind of coordinates; a formula has its own")
    if not kind:
        formula(name)  # an unknown name
    answers, found = (_CageAnswers if kind else _Answers)(name, f, order), _program(program)
    with tempfile.TemporaryDirectory(prefix="cageproof") as folder, socket.socket(socket.AF_UNIX) as listening:
        listening.bind(f"{folder}/socket")
        listening.listen()
        what = shlex.join([sys.executable or "python3", "-I", "-S", str(_RELAY), f"{folder}/socket"])
        words = ["judge", f"callable={what}", "--kind" if kind else "--formula", name, "--samples", samples, "--regimes", regimes]
        words += ["--seed", seed, "--seconds", seconds, *(["--dimension", dimension] if kind else [])]
        if promise is not None:
            words += ["--promise", promise, "--measure", measure]
        done = _run([found, *map(str, words), "--quiet", "--out", f"{folder}/out"], listening, answers, isolate)
        certificate = Path(folder, "out/certificate.json")
        if done.returncode not in (0, 1) or not certificate.is_file():
            raise Error(done.stderr.strip().split("\n")[-1] or f"{found} ended with {done.returncode}")
        return json.loads(certificate.read_text())
