#!/usr/bin/env bash
# The second half of the lecture "Recursion and Heckbert's Taxonomy" (TU Wien Rendering #11), as commands: what ray
# casting, radiosity, recursive ray tracing and global illumination capture of one scene, the two paths it works out by
# hand, the recursive tracer with everything it shows that is not light transport, and the closing quiz.
#
# Usage: examples/lecture.sh      with heckbert on the PATH, or its path in $HECKBERT
set -euo pipefail
heckbert=$(command -v "${HECKBERT:-heckbert}")
heckbert=$(realpath "$heckbert")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

say() { printf '\n'; printf '# %s\n' "$@"; }
ask() { # a command whose answer may be no
  local argument line='$ heckbert'
  for argument; do
    [[ $argument =~ ^[A-Za-z0-9@.-]+$ ]] || argument="'$argument'"
    line+=" $argument"
  done
  printf '%s\n' "$line"
  "$heckbert" "$@" || [ $? -eq 1 ]
}
settings=(--size 128x128 --spp 64 --seed 1 --quiet)

say "One scene: a mirror ball and a glass ball in a diffuse room. Every path is recorded as a word, light to eye."
"$heckbert" render lecture "${settings[@]}" --record scene.paths.exr

say "Ray casting stops at the first surface: at most one diffuse bounce." "Mirrors and glass are black."
ask query scene.paths.exr @ray-casting
say "Radiosity follows any number of diffuse bounces, and no other."
ask query scene.paths.exr @radiosity
say "The recursive ray tracer: at most one diffuse bounce, then any number of specular ones."
ask query scene.paths.exr @lecture
say "Global illumination: everything."
ask query scene.paths.exr @global-illumination

say "Two paths worked out on the blackboard:" \
    "LDDE leaves the light, meets the wall, the floor, and the eye; LSSE goes in and out of the glass ball."
ask query scene.paths.exr LDDE LSSE
for algorithm in ray-casting radiosity lecture global-illumination; do
  ask match "@$algorithm" LDDE LSSE --explain
done

say "'*' is any number, also none: radiosity contains LE, the lamp itself; and either reading direction will do."
ask match 'L D* E' LE LDE LDDE
ask grammar equal 'L D* E' 'E D* L'

say "What recursive ray tracing lacks: the shortest path of global illumination that it cannot find."
ask grammar subset 'L (D|S)* E' 'L D? S* E'

say "Run the lecture's tracer itself. All its words are in its grammar." \
    "Its mirror ray at diffuse surfaces and its ambient term are no light paths and are counted apart."
"$heckbert" render lecture "${settings[@]}" --algorithm lecture --record tracer.paths.exr
ask coverage tracer.paths.exr --grammar lecture --top 4

say "Quiz: in a ray-traced picture there is a shadow that is not black. Why?" \
    "Not because of any path: no word of the tracer reaches a point that sees neither the lamp nor a mirror." \
    "It is the ambient term, the line above that belongs to no path. Global illumination fills shadows with words:"
ask classify scene.paths.exr --top 6
