#!/usr/bin/env bash
# Runs the commands of the README's tour, block by block in their order, in an empty folder, and stops at the first that
# fails. The one block marked "setup", which puts the program on the PATH, is replaced by the program under test.
# Usage: run_tour.sh README.md FOLDER_OF_HECKBERT
set -euo pipefail
readme=$1
export PATH="$2:$PATH"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$readme" >tour.sh
count=$(grep -c '^heckbert ' tour.sh)
[ "$count" -ge 10 ] || { echo "found only $count commands in the tour of $readme" >&2; exit 1; }
bash -euxo pipefail tour.sh
for made in lecture.exr lecture.png lecture.paths.exr caustics.exr rest.exr lecture.html lecture-sheet.png; do
  [ -s "$made" ] || { echo "the tour has not made $made" >&2; exit 1; }
done
echo "$count commands ran"
