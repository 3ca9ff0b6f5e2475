#!/usr/bin/env bash
# What becomes of the stream of feed_own_paths.cpp: a record like any other.
#
# Usage: examples/feed_own_paths.sh      with heckbert and feed_own_paths on the PATH, or in $HECKBERT and $FEED
set -euo pipefail
heckbert=$(realpath "$(command -v "${HECKBERT:-heckbert}")")
feed=$(realpath "$(command -v "${FEED:-feed_own_paths}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

"$feed" | "$heckbert" record import - -o rooms.paths.exr --quiet
"$heckbert" query rooms.paths.exr 'L E' 'L D E' 'L S+ E' 'L S+ D E' --quiet
