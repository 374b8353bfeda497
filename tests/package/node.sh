#!/usr/bin/env bash
# Installs the npm package `vidno` in a fresh project, and compares what it writes with what the native program writes, byte for byte.
# node.sh FOLDER-OF-PACKAGES PROGRAM
set -euo pipefail
packages=$(cd "$1" && pwd)
program=$(realpath "$2")
lessons=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../lessons" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm init -y >/dev/null
npm install --offline --no-audit --no-fund --silent "$packages"/vidno-[0-9]*.tgz

# Runs both with the same words, each in a folder of its own, and compares the outputs, the messages, the status and the files.
mkdir node native
same() {
    local statuses
    statuses=$(
        set +e
        (cd node && "$work/node_modules/.bin/vidno" "$@" >out 2>messages)
        printf '%s ' $?
        (cd native && "$program" "$@" >out 2>messages)
        printf '%s' $?
    )
    diff -r node native || {
        echo "vidno $*: npx vidno differs from the program" >&2
        exit 1
    }
    [[ ${statuses% *} == "${statuses#* }" ]] || {
        echo "vidno $*: statuses $statuses" >&2
        exit 1
    }
    echo "  same: vidno ${*/#$lessons/lessons}"
}

for method in warnock zbuffer weiler-atherton; do
    same trace "$lessons"/05-polygon-clip/scene.json --method "$method" --check -o run.jsonl
    same figure run.jsonl --step 30 --show picture,windows,list,listing --language ru -o figure.tex
    same replay run.jsonl -o states.jsonl
done
for scene in "$lessons"/[0-9]*/*.json "$lessons"/surfaces/*.json; do
    [[ $scene != */lesson.json ]] || continue
    same trace "$scene" -o run.jsonl
    same check "$scene" --kernel float --list decisions.csv
    same figure run.jsonl --step 30 -o figure.svg
    same figure run.jsonl -o figure.tex
    same need "$scene" -o least.json
done
# Each function of formulas, and a power that two products round otherwise.
for formula in 'sin(x) * cos(z) + tan(x / 4)' 'asin(x / 4) + acos(z / 4) + atan(x) + atan2(x, z)' \
    'sinh(x) * cosh(z) + tanh(x)' 'asinh(x) + acosh(z * z + 1.5) + atanh(x / 4)' \
    'exp(-x * x) + ln(z * z + 1) + log(x * x + 2) + log2(x * x + 3) + log10(z * z + 4)' 'x^3 - z^5 + abs(x)^(1 / 3) + 2^-x' \
    'x < z ? max(x, 2, z) : sqrt(abs(x)) - sign(z)'; do
    cat >surface.json <<END
{"window": {"x": 0, "y": 0, "width": 200, "height": 150}, "function": "$formula", "x": [-1.7, 2.9], "z": [2.2, -0.9],
 "curves": 12, "samples": 100, "view": {"origin": [10, 90], "across": [120, 10], "back": [4, -3], "up": 20}}
END
    same trace "$work/surface.json" --method floating-horizon -o curves.jsonl
done
for decision in "$lessons"/maps/*.json; do
    same map "$decision" -o map.json
    same figure "$decision" -o map.svg
done
same trace "$lessons"/../tests/wasm/hills.json --method floating-horizon -o curves.jsonl
same trace "$lessons"/08-show-line/scene.json --method weiler-atherton -o regions.jsonl
same diff run.jsonl curves.jsonl
same methods --json
same trace missing.json -o run.jsonl
same trace "$lessons"/02-corner-depths/scene.json --kernel nonsense -o run.jsonl

# A compressed trace is read by either program.
npx --offline vidno trace "$lessons"/05-polygon-clip/scene.json -o run.jsonl.gz
"$program" trace "$lessons"/05-polygon-clip/scene.json -o plain.jsonl
zcat run.jsonl.gz | cmp - plain.jsonl
npx --offline vidno diff run.jsonl.gz plain.jsonl
head -c 2000 run.jsonl.gz >cut.jsonl.gz
if npx --offline vidno replay cut.jsonl.gz -o picture.ppm 2>messages; then exit 1; fi
grep -q 'cut short' messages
echo "== npx vidno writes what the program writes"
