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
# The scenes of the lessons, without the surfaces that are given by a formula.
for scene in "$lessons"/[0-9]*/*.json; do
    if [[ $scene == */lesson.json ]] || grep -q '"function"' "$scene"; then continue; fi
    same trace "$scene" -o run.jsonl
    same check "$scene" --kernel float --list decisions.csv
    same figure run.jsonl --step 30 -o figure.svg
    same figure run.jsonl -o figure.tex
    same need "$scene" -o least.json
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
