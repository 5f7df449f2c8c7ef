#!/usr/bin/env bash
# Holds the layers and rooms of docs/architecture.md: a folder of rigor/ includes itself and the layers below it, a
# room of a layer itself and the rooms below it, nothing up or across; and no two headers define a type of the same
# name. Prints each offence and fails.
# usage: tools/check_layers.sh [root of the repository]
set -euo pipefail
cd "${1:-.}"

# layer: the layers that it may include.
layers='
core:
math: core
geometry: core math
solver: core math
model: core math geometry
dynamics: core math geometry solver model
contact: core math geometry solver model dynamics
bulk: core math geometry solver model dynamics
sim: core math geometry solver model dynamics contact bulk
io: core math geometry model dynamics sim
view: core math geometry model dynamics sim io
study: core math geometry model dynamics sim io view
api: core math geometry model dynamics sim bulk io view
'
# layer: its rooms from the lowest up; `.` stands for the files that lie in the folder of the layer itself.
rooms='
geometry: exact lanes shape mass broad_phase convex mesh rays decomposition distance mesh_penetration contacts motion
solver: linear coulomb motion cones .
contact: system resting impact penalty .
bulk: lanes threads state narrow_phase broad_phase matching graph direct contacts gyroscopic joints sleep passing .
sim: pairs method report witness fixed_steps drives islands event_driven time_stepping bulk handover penalty audit .
io: files mesh scene trajectory
view: recording 3d plot page live
study: formula sampling plan run workers kinds . answer
'

bad=0
# The headers that users include, rigor/rigor.hpp and rigor/geometry.hpp, stand above all layers.
sources=$(find rigor -mindepth 2 '(' -name '*.hpp' -o -name '*.cpp' -o -name '*.inl' ')' | LC_ALL=C sort)

# Every file lies in a layer, and in one of its rooms where it has any. (The first line of awk reads the two tables.)
awk -v layers="$layers" -v rooms="$rooms" '
  function table(text, into,   n, lines, i, fields, k) {
    n = split(text, lines, "\n")
    for (i = 1; i <= n; ++i) {
      if (split(lines[i], fields, /[: ]+/) == 0) continue
      into[fields[1]] = 1
      for (k = 2; fields[k] != ""; ++k) into[fields[1], fields[k]] = k
      delete fields
    }
  }
  # rigor/layer/room/name.hpp or rigor/layer/name.hpp
  function layer_of(path,   parts) { split(path, parts, "/"); return parts[2] }
  function room_of(path,   parts, n) { n = split(path, parts, "/"); return n > 3 ? parts[3] : "." }
  function complain(text) { print text; bad = 1 }

  BEGIN { table(layers, below); table(rooms, rank) }

  FNR == 1 {
    layer = layer_of(FILENAME)
    room = room_of(FILENAME)
    if (!(layer in below)) complain(FILENAME ": rigor/" layer " is not a layer of docs/architecture.md")
    else if (layer in rank ? !((layer, room) in rank) : room != ".")
      complain(FILENAME ": " room " is not a room of rigor/" layer)
  }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    place = FILENAME ":" FNR ": "
    path = $0
    sub(/^[^"]*"/, "", path)
    sub(/".*$/, "", path)
    if (path !~ /^rigor\//) { complain(place "include paths start at the root: \"rigor/...\""); next }
    target = layer_of(path)
    if (target != layer) {
      if (!((layer, target) in below)) complain(place layer " may not include rigor/" target "/")
    } else if ((layer in rank) && rank[layer, room_of(path)] > rank[layer, room]) {
      complain(place layer "/" room " may not include " layer "/" room_of(path))
    }
  }
  END { exit bad }' $sources || bad=1

# The linker merges what has the same name: a type of namespace rigor is defined in one header only.
twice=$(awk '
  FNR == 1 { inner = 0 }
  /^namespace [a-z:]+ \{/ { inner = $2 != "rigor" }
  /^}  \/\/ namespace/ { inner = 0 }
  !inner && /^(struct|class) .*[{:]/ { print $2 ~ /^alignas/ ? $3 : $2 }' $(grep '\.hpp$' <<<"$sources") | sort | uniq -d)
if [ -n "$twice" ]; then
  echo "types with two definitions: $twice"; bad=1
fi
[ $bad = 0 ] && echo "layers: every include goes down"
exit $bad
