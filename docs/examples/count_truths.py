# SPDX-License-Identifier: MIT
"""count_truths.py REPORT/summary.json.gz: at how many inputs formulas were compared with the integral itself, and at how many with what stands in for it."""
import gzip
import json
import sys

inputs, integrated, comparisons = {}, {}, 0
for row in json.load(gzip.open(sys.argv[1]))["rows"]:
    if row["section"] != "element":
        continue
    place = row["subject"], row["regime"]
    if row["check"] == "truth":  # one evaluation, one scalar, one order of derivatives
        inputs[place] = max(inputs.get(place, 0), row["samples"])
        comparisons += row["samples"]
    if row["check"] == "integral":
        integrated[place] = max(integrated.get(place, 0), row["samples"])
print(f"{sum(integrated.values()):,} of {sum(inputs.values()):,} inputs integrated, {comparisons:,} comparisons")
