#!/usr/bin/env bash
# Makes the pictures of docs/gallery.md anew: each scene at a moment that shows what it is about, 320 by 180 pixels.
# With `film` the moving picture of README.md, with `tutorial` those of docs/tutorial.md. Needs ffmpeg.
# usage: tools/make_pictures.sh PROGRAM [film | tutorial | SCENE...]   (default: all scenes)
set -euo pipefail
program=$(realpath "$1")
shift
cd "$(dirname "$0")/.."

# scene, time [s] and options of the camera where its own choice is not the best.
moments() {
  cat <<'TABLE'
andrews 0.02
arch 0
backspin 0.4
ball_on_two 0.42
billiards 0.25
bouncing_ball 0.35
bowl 0.3 --eye=2,-3,3.6 --target=0,0,-0.3
bowling 0.3
bricard 2
bridge 3
bullet 0 --eye=-1.5,-3,1.2 --target=0.4,0.2,0
card_house 0
chain 0.5 --eye=1,-2.2,0 --target=1,0,-0.5
chain_reaction 1.1
cradle 0.45
cylinder_pyramid 0
dice 0.22
domino_spiral 1.5
dominoes 0.4
double_pendulum 0.35
energy_gain 0.1
euler_disk 11
four_bar 0.4
free_chain 2
gas 0.5
gear_pair 0.2
governor 3
hail 0.4
heavy_top 0.3
hopper 3
incline_race 0.5
l_shape 0.4
n_four_bar 0.5
newtons_cradle 0.46
oblique_box 0.02
overhang 0
painleve 0.05
parallel_bars 0.3
pendulum 0.35
pile 0.5
platter 7.2
pyramid 0
ragdolls 3 --eye=4,-6,3 --target=0,0,0.4
rain 2.5
ramp_slide 6
rattleback 0.5
rimless_wheel 2
rock_pile 0.5
rocking_block 0.1
rocks 0.6
rod 0.2
roll_off 0.6
rolling_cup 1
rolling_disk 0.5
rolling_plate 0.5
sleeping_top 1
slide_to_roll 0.4
slider_crank 0.3
spinning_top 1
stack_20 0
steady_top 1
superball 0.25
table 0
tennis_racket 6
terrain 0.4
tippe_top 1.2
torus_on_peg 0.3
touching_cradle 0.3
turntable 4
upright_disk 0.5
wedge 0.2
TABLE
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# What a command says is shown only if it fails.
quiet() { "$@" 2>"$work/said" || { cat "$work/said" >&2; return 1; }; }

picture() {  # scene, time, options: drawn at twice the size, which smooths its edges
  quiet "$program" render "scenes/$1.yaml" --time "$2" "${@:3}" --size 640x360 -o "$work/p.png"
  ffmpeg -nostdin -y -loglevel error -i "$work/p.png" -vf scale=320:180:flags=area "docs/img/$1.png"
}

# The chain reaction as an animated WebP, twenty pictures a second of its own time.
film() {
  quiet "$program" render scenes/chain_reaction.yaml --frames 64 --size 1440x600 -o "$work/f.png"
  ffmpeg -nostdin -y -loglevel error -framerate 16 -i "$work/f_%04d.png" -vf scale=720:300:flags=area -c:v libwebp_anim -quality 70 \
    -compression_level 6 -loop 0 docs/img/chain_reaction.webp
}

# shrink PICTURE: $work/p.png as that picture of the tutorial, at half its size.
shrink() { ffmpeg -nostdin -y -loglevel error -i "$work/p.png" -vf scale=480:-1:flags=area "docs/img/tutorial_$1.png"; }

# The scenes of the tutorial, as the page has them, each at a moment; a sheet, a changed value, and a plot.
tutorial() {
  local name time
  awk -v to="$work/" '
    match($0, /`[a-z]+\.yaml`:$/) { name = substr($0, RSTART + 1, RLENGTH - 3); seen = 0; next }
    name != "" && /^    / { print substr($0, 5) >(to name); seen = 1; next }
    name != "" && seen && !/^$/ { name = "" }' docs/tutorial.md
  while read -r name time; do
    quiet "$program" render "$work/$name.yaml" --time "$time" --size 960x540 -o "$work/p.png"
    shrink "$name"
  done <<'TABLE'
fall 0.3
bounce 0.95
slope 1.1
wall 0
swing 0.7
mill 1
wreck 1.3
TABLE
  "$program" run "$work/fall.yaml" --duration 1 -o "$work/p.png" --quiet
  shrink sheet
  quiet "$program" render "$work/wreck.yaml" --set materials.wood.friction=0.05 --time 1.3 --size 960x540 -o "$work/p.png"
  shrink slippery
  "$program" run "$work/wreck.yaml" -o "$work/run.h5" --quiet
  "$program" plot "$work/run.h5" energy.kinetic energy.total -o "$work/p.png"
  shrink energy
}

case ${1:-} in
  film) film ;;
  tutorial) tutorial ;;
  *)
    while read -r scene time options; do
      [ $# = 0 ] || [[ " $* " == *" $scene "* ]] || continue
      # shellcheck disable=SC2086 # The options are words.
      picture "$scene" "$time" $options
    done < <(moments) ;;
esac
