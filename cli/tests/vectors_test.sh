#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# vectors_test.sh CAGEPROOF CHECKERS: test vectors are the same files each time, a sound function passes them, and each kind of wrong one fails those that aim at it.
set -u
cageproof=$1 checkers=$2
failures=0
fail() {
  printf 'FAILED: %s\n' "$1"
  failures=1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 2

"$cageproof" vectors --formulas triangle.solid_angle,segment.single_layer --out one >stdout || fail "vectors: $(cat stdout)"
"$cageproof" vectors --formulas triangle.solid_angle,segment.single_layer --out two --jobs 1 >/dev/null || fail "vectors with one thread"
for file in one/*; do
  cmp -s <(sed 's/"command":"[^"]*"//' "$file") <(sed 's/"command":"[^"]*"//' "two/${file#one/}") || fail "$file differs between two runs"
done
vectors=one/triangle.solid_angle.json
check() { /usr/bin/python3 "$@" >stdout 2>stderr; }
check "$checkers/check.py" $vectors || fail "a sound solid angle: $(cat stdout stderr)"
grep -q '^all: \([0-9]*\) of \1 within 64 units$' stdout || fail "all vectors pass: $(cat stdout)"

# wrong NAME OLD NEW FLAG: with OLD replaced by NEW in the function, vectors that aim at FLAG fail.
wrong() {
  python3 - "$checkers/check.py" "$2" "$3" >wrong.py <<'END'
import sys
text = open(sys.argv[1]).read()
assert sys.argv[2] in text
print(text.replace(sys.argv[2], sys.argv[3], 1))
END
  check wrong.py $vectors
  [ $? -eq 1 ] || fail "$1 passes: $(cat stdout stderr)"
  grep "^$4: " stdout | awk '{exit !($2 < $4)}' || fail "$1 passes what aims at it: $(cat stdout)"
}
wrong 'a threshold on volumes' 'if volume == 0:' 'if abs(volume) < 1e-6:' height-threshold
wrong 'half a jump in the plane' 'return [[angle_in_plane(e)]]' 'return [[2 * math.pi]]' half-in-plane
wrong 'a determinant in floats' 'Fraction(s) - Fraction(t) for' 'Fraction(s - t) for' cancellation

# A gradient that is returned is checked, too: zero is no vector's.
sed '0,/return \[\[2 \* /s//return [[0.0] * 3][:0] + [[2 * /; s/, below)\]\]$/, below)], [0.0, 0.0, 0.0]]/' "$checkers/check.py" >gradient.py
check gradient.py $vectors
[ $? -eq 1 ] || fail "a gradient of zeros passes: $(cat stdout stderr)"

# The checkers in C and JavaScript count what Python's counts.
grep -v '^worst' <(check "$checkers/check.py" $vectors; cat stdout) >counts
cc -std=c99 -O1 -Wall -Wextra -Werror "$checkers/check.c" -lm -o check || fail "check.c"
./check one/triangle.solid_angle.txt >stdout || fail "C: $(cat stdout)"
diff <(sort counts) <(grep -v '^worst' stdout | sort) || fail "C counts otherwise"
node "$checkers/check.js" $vectors >stdout || fail "JavaScript: $(cat stdout)"
diff <(sort counts) <(grep -v '^worst' stdout | sort) || fail "JavaScript counts otherwise"
sed 's/if (determinant == 0)/if (fabs(determinant) < 1e-6)/' "$checkers/check.c" >wrong.c
cc -std=c99 -O1 -I "$checkers" wrong.c -lm -o wrong && ./wrong one/triangle.solid_angle.txt >stdout
[ $? -eq 1 ] || fail "C: a threshold on volumes passes: $(cat stdout)"
sed 's/if (volume === 0n) return/if (volume < 10n ** 30n) return/' "$checkers/check.js" >wrong.js
node wrong.js $vectors >stdout
[ $? -eq 1 ] || fail "JavaScript: a threshold on volumes passes: $(cat stdout)"

# Damaged files are refused by all three, and so are bounds that are no numbers, and files of another formula.
/usr/bin/python3 - $vectors one/triangle.solid_angle.txt <<'END' || fail "damaged files could not be written"
import json
import sys
data = json.load(open(sys.argv[1]))
first = data["vectors"][0]
damaged = {"list": [], "null": None, "number": data | {"vectors": 5}, "numbers": data | {"vectors": [1]}, "empty": data | {"vectors": [{}]},
           "none": data | {"vectors": []}, "bound": data | {"bound": "x"}, "unit": {k: v for k, v in data.items() if k != "unit"},
           "other": data | {"formula": "triangle.single_layer"}}
for name, change in {"hexadecimal": {"point": ["zz", "0x0p+0", "0x0p+0"]}, "large": {"point": ["0x1p+5000"] * 3}, "decimal": {"value": ["abc"]}}.items():
    damaged[name] = data | {"vectors": [first | change]}
for key in ("value", "defects"):
    damaged["without_" + key] = data | {"vectors": [{k: v for k, v in first.items() if k != key}]}
for name, content in damaged.items():
    json.dump(content, open(f"damaged_{name}.json", "w"))
text = open(sys.argv[2]).read().splitlines(keepends=True)
head = text[0].split()
for name, lines in {"fewer": [" ".join([head[0], "10", *head[2:]]) + "\n", *text[1:]], "inputs": [" ".join([*head[:2], "3", head[3]]) + "\n", *text[1:]],
                    "long": [text[0], text[1].rstrip("\n") + " 1" * 9000 + "\n", *text[2:]], "nan": [text[0], " ".join([text[1].split()[0], "nan", *text[1].split()[2:]]) + "\n", *text[2:]],
                    "other": [text[0].replace("solid_angle", "single_layer"), *text[1:]], "cut": text[:-1]}.items():
    assert lines != text, name
    open(f"damaged_{name}.txt", "w").writelines(lines)
END
for refused in "./check nothing.txt" "./check $vectors" "./check one/triangle.solid_angle.txt abc" "/usr/bin/python3 $checkers/check.py $vectors abc" \
  "node $checkers/check.js $vectors abc" "node $checkers/check.js nothing.json"; do
  $refused >stdout 2>stderr
  [ $? -eq 2 ] && grep -q 'cannot read vectors' stderr || fail "$refused: $(cat stdout stderr)"
done
for file in damaged_*.json; do
  for checker in "/usr/bin/python3 $checkers/check.py" "node $checkers/check.js"; do
    $checker "$file" >stdout 2>stderr
    [ $? -eq 2 ] && grep -q 'cannot read vectors' stderr || fail "$checker $file: $(cat stdout stderr)"
  done
done
for file in damaged_*.txt; do
  ./check "$file" >stdout 2>stderr
  [ $? -eq 2 ] && grep -q 'cannot read vectors' stderr || fail "C, $file: $(cat stdout stderr)"
done

# A function that answers nothing, or throws, passes nothing.
sed 's/^    e = \[\[Fraction/    return []\n&/' "$checkers/check.py" >silent.py
sed 's/^    e = \[\[Fraction/    raise TypeError\n&/' "$checkers/check.py" >thrown.py
sed 's/^  const e = exactDifferences/  return []\n&/' "$checkers/check.js" >silent.js
sed 's/^  const e = exactDifferences/  throw 1\n&/' "$checkers/check.js" >thrown.js
for without in "/usr/bin/python3 silent.py" "/usr/bin/python3 thrown.py" "node silent.js" "node thrown.js"; do
  $without $vectors >stdout 2>stderr
  [ $? -eq 1 ] && grep -q '^all: 0 of ' stdout || fail "$without: $(cat stdout stderr)"
done

# Truths are those of the integral in 50 digits.
/usr/bin/python3 - "$cageproof" $vectors <<'END' || fail "truths are not those of the integral"
import json
import subprocess
import sys
from fractions import Fraction
data = json.load(open(sys.argv[2]))
some = [v for v in data["vectors"] if v["regime"] not in ("on-face", "on-edge", "on-vertex", "on-plane", "on-line", "hunted")][::12]
lines = "\n".join(json.dumps({"element": v["element"], "point": v["point"]}) for v in some)
run = subprocess.run([sys.argv[1], "eval", "--formula", data["formula"], "--evaluation", "multiprecision", "--scalar", "mp50"], input=lines, capture_output=True, text=True)
answers = [json.loads(line) for line in run.stdout.splitlines()]
assert len(answers) == len(some) >= 5, (len(some), run.stderr)
for vector, answer in zip(some, answers):
    truth, integral = Fraction(vector["value"][0]), Fraction(answer["value"][0])
    assert abs(truth - integral) <= Fraction(1, 10**28) * max(abs(truth), Fraction(1, 10**30)), (vector, answer)
END

# Whole cages: sound mean value coordinates pass, the same numbers are counted in all three languages, and wrong forms fail what aims at them.
"$cageproof" vectors --kinds mean_value --cages small-tetrahedron,l-shape --out cages >stdout || fail "vectors of cages: $(cat stdout)"
cp "$checkers/check.py" .
cc -std=c99 -O1 -Wall -Wextra -Werror "$checkers/check_cage.c" -lm -o check_cage || fail "check_cage.c"
for cage in small-tetrahedron l-shape; do
  vectors=cages/mean_value.$cage
  check "$checkers/check_cage.py" "$vectors.json" || fail "$cage: sound coordinates: $(cat stdout stderr)"
  grep -v '^worst' stdout | sort >counts
  grep -q '^all: \([0-9]*\) of \1 within 64 units$' counts || fail "$cage: all vectors pass: $(cat counts)"
  ./check_cage "$vectors.txt" >stdout || fail "$cage, C: $(cat stdout)"
  diff counts <(grep -v '^worst' stdout | sort) || fail "$cage: C counts otherwise"
  node "$checkers/check_cage.js" "$vectors.json" >stdout || fail "$cage, JavaScript: $(cat stdout)"
  diff counts <(grep -v '^worst' stdout | sort) || fail "$cage: JavaScript counts otherwise"
done
# wrong_cage NAME OLD NEW FLAG CAGE: as `wrong`, of the checker of cages.
wrong_cage() {
  /usr/bin/python3 - "$checkers/check_cage.py" "$2" "$3" >wrong.py <<'END'
import sys
text = open(sys.argv[1]).read()
assert sys.argv[2] in text
print(text.replace(sys.argv[2], sys.argv[3], 1))
END
  check wrong.py "cages/mean_value.$5.json"
  [ $? -eq 1 ] || fail "$1 passes: $(cat stdout stderr)"
  grep "^$4: " stdout | awk '{exit !($2 < $4)}' || fail "$1 passes what aims at it: $(cat stdout)"
}
wrong_cage 'a threshold on volumes' 'if det == 0:' 'if abs(det) < 1e-10:' size-threshold small-tetrahedron
wrong_cage 'no case on the cage' 'if on:' 'if False:' no-case-on-cage small-tetrahedron
wrong_cage 'no case on the polygon' 'if on:' 'if False:' no-case-on-cage l-shape
sed 's/det == 0/fabs(det) < 1e-10/' "$checkers/check_cage.c" >wrong.c
cc -std=c99 -O1 -I "$checkers" wrong.c -lm -o wrong && ./wrong cages/mean_value.small-tetrahedron.txt >stdout
[ $? -eq 1 ] || fail "C: a threshold on volumes of a cage passes: $(cat stdout)"
# Sums of truths are one, and so are their moments the point, inside and outside.
/usr/bin/python3 - <<'END' || fail "truths of cages"
import json
from fractions import Fraction
for cage in ("small-tetrahedron", "l-shape"):
    data = json.load(open(f"cages/mean_value.{cage}.json"))
    exact = [[Fraction(float.fromhex(x)) for x in v] for v in data["vertices"]]
    size = max(abs(x) for v in exact for x in v)
    regimes = {v["regime"] for v in data["vectors"]}
    assert "inside" in regimes and any(r.startswith("on-") for r in regimes) and any(r.startswith("near-") for r in regimes), regimes
    for v in data["vectors"]:
        truth = [Fraction(t) for t in v["value"]]
        assert abs(sum(truth) - 1) < Fraction(1, 10**38), v
        for axis, x in enumerate(v["point"]):
            moment = sum(t * corner[axis] for t, corner in zip(truth, exact))
            assert abs(moment - Fraction(float.fromhex(x))) < size * Fraction(1, 10**37), v
END
for refused in "./check_cage nothing.txt" "./check_cage one/triangle.solid_angle.txt" "/usr/bin/python3 $checkers/check_cage.py one/triangle.solid_angle.json" \
  "node $checkers/check_cage.js one/triangle.solid_angle.json"; do
  $refused >stdout 2>stderr
  [ $? -eq 2 ] && grep -q 'cannot read vectors' stderr || fail "$refused: $(cat stdout stderr)"
done
# A damaged file is refused as a whole.
/usr/bin/python3 - <<'END'
import json
good = open("cages/mean_value.small-tetrahedron.json").read()
def put(name, change):
    data = json.loads(good)
    change(data)
    json.dump(data, open(f"damaged_{name}.json", "w"))
put("vectors", lambda d: d["vectors"].pop())
put("blocks", lambda d: d.update(blocks=[]))
put("size", lambda d: d["blocks"][0].update(size=3))
put("format", lambda d: d.update(format="cageproof cage vectors 2"))
put("face", lambda d: d["faces"][0].append(3))
put("index", lambda d: d["faces"][0].__setitem__(2, 9))
put("denominators", lambda d: d["vectors"][3].update(denominators=[]))
put("minus", lambda d: d["vectors"][3].update(denominators=["-1"]))
put("number", lambda d: d["vectors"][3]["value"].__setitem__(0, 0.5))
put("defects", lambda d: d["vectors"][3].update(defects=["nothing"]))
put("unit", lambda d: d.update(unit="0x0p+0"))
text = open("cages/mean_value.small-tetrahedron.txt").read().splitlines(keepends=True)
words = text[-1].split(" ")
open("damaged_minus.txt", "w").writelines(text[:-1] + [" ".join(words[:-1] + ["-" + words[-1]])])
END
for damaged in damaged_*.json; do
  for checker in "/usr/bin/python3 $checkers/check_cage.py" "node $checkers/check_cage.js"; do
    $checker "$damaged" >stdout 2>stderr
    [ $? -eq 2 ] && grep -q 'cannot read vectors' stderr && [ "$(wc -l <stderr)" -eq 1 ] || fail "$checker $damaged: $(cat stdout stderr)"
  done
done
./check_cage damaged_minus.txt >stdout 2>stderr
[ $? -eq 2 ] && grep -q 'denominator is not positive' stderr || fail "C: a negative denominator: $(cat stdout stderr)"
"$cageproof" vectors --kinds nothing --out three >stdout 2>stderr
[ $? -eq 2 ] && [ ! -e three ] || fail "an unknown kind: $(cat stdout stderr)"

"$cageproof" vectors --formulas 'triangle.nothing' --out three >stdout 2>stderr
[ $? -eq 2 ] && [ ! -e three ] || fail "an unknown formula: $(cat stdout stderr)"
check "$checkers/check.py" nothing.json
[ $? -eq 2 ] && grep -q 'cannot read vectors' stderr || fail "a file that is not there"
[ "$failures" -eq 0 ] || exit 1
echo "vectors: ok"
