#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""A program that answers sevens, until the x of a point is 0.5: then it does what its argument says."""
import json
import os
import signal
import sys
import time

what = sys.argv[1] if len(sys.argv) > 1 else ""
for line in sys.stdin:
    query = json.loads(line)
    if "describe" in query:
        print(json.dumps({"formulas": {"triangle.single_layer": 0}, "about": "hostile 2.0"}), flush=True)
        continue
    answer = '{"value":[7]}'
    if query["point"][0] == 0.5:
        if what == "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        elif what == "raise":
            raise ValueError("no such point")
        elif what == "exit":
            sys.exit(0)
        elif what == "hang":
            time.sleep(1000)
        elif what == "garbage":
            answer = "what?"
        elif what == "nan":
            answer = '{"value":["nan"]}'
        elif what == "hexadecimal":
            answer = '{"value":["0x1.cp+2"]}'
        elif what == "short":
            answer = '{"value":[]}'
        elif what == "decline":
            answer = '{"error":"not this one"}'
        elif what == "twice":
            answer += "\n" + answer
        elif what == "endless line":
            while True:
                sys.stdout.write("7" * 65536)
        elif what == "endless lines":
            while True:
                sys.stdout.write("7\n" * 65536)
        elif what == "nested":
            answer = '{"value":' + "[" * 400000 + "7" + "]" * 400000 + "}"
        elif what == "blank lines":
            while True:
                sys.stdout.write("\n" * 4096)
        elif what == "drip":
            while True:
                sys.stdout.write(" ")
                time.sleep(0.05)
        elif what == "fork":
            if os.fork() == 0:
                os.setsid()
                time.sleep(1000)
    print(answer, flush=True)
