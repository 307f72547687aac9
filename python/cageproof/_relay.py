# SPDX-License-Identifier: MIT
"""Run by `cageproof judge` in place of a callable: python -I -S _relay.py SOCKET. Passes questions to the process that has it, and answers back.

Knows only the smallest part of the standard library, so that it starts quickly. An answer that begins with "!" ends it: a text for standard error."""

import os
import select
import socket
import sys

SIZE = 1 << 16
ENDED = "the callable's process ended"


def main(connection: socket.socket) -> str:
    """The text to end with: "" where all was answered."""
    poll, questions, rest, open_, ended = select.poll(), b"", b"", 0, False
    while open_ or not ended:
        # A side that has something to say never waits for the other.
        if not ended:
            poll.register(0, 0 if questions else select.POLLIN)
        poll.register(connection, select.POLLIN | (select.POLLOUT if questions else 0))
        events = dict(poll.poll())
        if events.get(0) and not questions:
            questions = os.read(0, SIZE)
            open_ += questions.count(b"\n")
            if not questions:
                ended = True
                poll.unregister(0)
        event = events.get(connection.fileno(), 0)
        try:
            if event & select.POLLOUT:
                questions = questions[connection.send(questions, socket.MSG_DONTWAIT) :]
            if event & ~select.POLLOUT:
                answers = connection.recv(SIZE)
                if not answers:
                    return ENDED if open_ else ""
                lines = (rest + answers).split(b"\n")
                rest = lines.pop()
                for line in lines:
                    if line.startswith(b"!"):
                        return line[1:].decode(errors="replace")
                    open_ -= 1
                    os.write(1, line + b"\n")
        except BlockingIOError:
            continue
        except OSError:
            return ENDED
    return ""


with socket.socket(socket.AF_UNIX) as one:
    one.connect(sys.argv[1])
    sys.exit(main(one) or 0)
