#!/usr/bin/env bash
# Holds README.md, CONTRIBUTING.md, CHANGELOG.md and docs/ to what is there. Links, headings, pages, files, folders,
# scenes, options, sections and identifiers that a page names exist; command lines run, in a temporary folder and for a
# short simulated time, and print what the page says. Prints each offence and fails.
# usage: tools/check_docs.sh PROGRAM [root of the repository]
set -euo pipefail
export LC_ALL=C
program=$(realpath "$1")
cd "${2:-$(dirname "$0")/..}"
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
bad=0
complain() { echo "$1"; bad=1; }

mapfile -t pages < <(find README.md CONTRIBUTING.md CHANGELOG.md docs -name '*.md' | sort)

# --- What the repository has ------------------------------------------------------------------------------------------

list_files() {
  find . \( -name .git -o -name build -o -name out -o -name node_modules \) -prune -o -type f -print | sed 's|^\./||' | sort
}

# Every word of the code, comments left out, and of the names of its files.
list_words() {
  local code
  mapfile -t code < <(grep -E '^(rigor|apps|python|examples|tests|benchmarks|tools|viewer/src|cmake|scenes|schema)/|^CMake|^Makefile$' \
    "$work/files" | grep -E '\.(hpp|cpp|inl|py|ts|json|yaml|cmake|txt)$|^Makefile$')
  { sed -E 's@(^|[^:"])//.*@\1@; s@^ *\*.*@@' "${code[@]}"; sed 's@[/.]@ @g' "$work/files"; } |
    tr -cs 'A-Za-z0-9_' '\n' | sort -u
}

# Every option that a command of the program, a tool or a benchmark has.
list_options() {
  local command
  for command in $("$program" --help | awk '/^Commands:/ { on = 1; next } /^$/ { on = 0 } on { print $1 }'); do
    "$program" "$command" --help | awk -v command="$command" '
      /^Options:/ { on = 1 }
      /^Examples:/ { on = 0 }
      on && /^ / {
        while (match($0, /[ ,]--?[A-Za-z][a-z0-9-]*/)) {
          print command, substr($0, RSTART + 1, RLENGTH - 1)
          $0 = substr($0, RSTART + RLENGTH)
        }
      }'
  done
  grep -ohE -- '--[a-z][a-z-]*' tools/*.py benchmarks/*.cpp | sed 's/^/tool /'
}

# --- What the pages say -----------------------------------------------------------------------------------------------

# Lines `place TAB kind TAB text`: kind is code (a line of a code block), span (in backticks), head (a heading) or link.
read_pages() {
  awk '
    function flush(   text, part) {
      text = paragraph
      while (match(text, /`[^`]+`/)) {
        print place "\tspan\t" substr(text, RSTART + 1, RLENGTH - 2)
        text = substr(text, RSTART + RLENGTH)
      }
      if (text ~ /`/) print place "\todd\t" text
      text = paragraph
      gsub(/`[^`]*`/, "", text)
      while (match(text, /\]\([^) ]+\)|src="[^"]+"/)) {
        part = substr(text, RSTART, RLENGTH)
        gsub(/^\]\(|\)$|^src="|"$/, "", part)
        print place "\tlink\t" part
        text = substr(text, RSTART + RLENGTH)
      }
      paragraph = ""
    }
    FNR == 1 { flush(); fenced = 0; blank = 1 }
    /^```/ { flush(); fenced = !fenced; next }
    fenced { print FILENAME ":" FNR "\tcode\t" $0; next }
    /^    / && blank { flush(); print FILENAME ":" FNR "\tcode\t" substr($0, 5); next }
    /^$/ { flush(); blank = 1; next }
    /^#/ { flush(); print FILENAME ":" FNR "\thead\t" $0 }
    /^\|/ { flush() }
    { if (paragraph == "") place = FILENAME ":" FNR; paragraph = paragraph (paragraph == "" ? "" : " ") $0; blank = 0 }
    END { flush() }' "${pages[@]}"
}

of_kind() { awk -F '\t' -v kind="$1" '$2 == kind { print $1 "\t" $3 }' "$work/pages"; }

# Headings as GitHub makes anchors of them: `page#anchor`.
list_anchors() {
  of_kind head | awk -F '\t' '{
    page = $1; sub(/:.*/, "", page)
    text = tolower($2)
    sub(/^#+ +/, "", text)
    gsub(/[][!"#$%&()*+,.\/:;<=>?@\\^`{|}~\047]/, "", text)
    gsub(/ /, "-", text)
    print page "#" text }'
}

# --- Links and pages --------------------------------------------------------------------------------------------------

check_links() {
  local place target page path
  list_anchors >"$work/anchors"
  : >"$work/linked"
  while IFS=$'\t' read -r place target; do
    page=${place%%:*}
    case $target in http://* | https://*) continue ;; '#'*) path=$page ;; *) path=$(dirname "$page")/${target%%#*} ;; esac
    path=$(realpath -m --relative-to=. "$path")
    [ -e "$path" ] || { complain "$place: no file $path"; continue; }
    [ "$path" = "$page" ] || echo "$path" >>"$work/linked"
    [[ $target != *'#'* ]] || grep -qxF "$path#${target#*#}" "$work/anchors" || complain "$place: no heading for $target"
  done < <(of_kind link)
  for page in "${pages[@]}"; do
    [ "$page" = README.md ] || grep -qxF "$page" "$work/linked" || complain "$page: no other page links to it"
  done
  while IFS=$'\t' read -r place target; do complain "$place: a backtick too many or too few: $target"; done < <(of_kind odd)
}

# --- Names ------------------------------------------------------------------------------------------------------------

# Names of examples, of other programs and of what is written, which are not in the tree.
strange='name.cpp name_test.cpp name_test linear_restitution rigor_test_io out/ /// --toggle-collect'

# Files, folders, tests and identifiers in backticks; files also in headers' short form, with the end of their path.
check_names() {
  awk -F '\t' -v strange="$strange" '
    function complain(what) { print $1 ": no " what; bad = 1 }
    BEGIN {
      in_span = "^[A-Z][a-z0-9]+[A-Z][A-Za-z0-9]*$|^[a-z][a-z0-9]*(_[a-z0-9]+)+_?$"
      in_code = "^[A-Z][a-z0-9]+[A-Z][A-Za-z0-9]*$|^[a-z][a-z][a-z]+(_[a-z][a-z][a-z]+)+$"  # Formulas have short names.
    }
    FILENAME ~ /files$/ {
      n = split($0, parts, "/")
      end = parts[n]
      is_end[end] = 1
      for (i = n - 1; i > 0; --i) { end = parts[i] "/" end; is_end[end] = 1 }
      for (i = 1; i < n; ++i) {
        folder = ""
        for (k = i; k < n; ++k) { folder = folder parts[k] "/"; is_folder[folder] = 1 }
      }
      next
    }
    FILENAME ~ /words$/ { is_word[$0] = 1; next }
    FILENAME ~ /options$/ { split($0, parts, " "); is_option[parts[2]] = 1; next }
    FNR == 1 { ++input; n = split(strange, parts, " "); for (i = 1; i <= n; ++i) is_strange[parts[i]] = 1 }
    {
      text = $2
      is_code = input > 1
      option = text
      sub(/[^a-z0-9-].*/, "", option)
      if (text ~ /^--[a-z]/ && !(option in is_option) && !(option in is_strange)) complain("option " option)
      if (text ~ /^[A-Za-z0-9_.\/-]+\/$/ && !(text in is_folder) && !(text in is_strange)) complain("folder " text)
      rest = text
      while (match(rest, /[A-Za-z0-9_<>.\/-]+\.(hpp|cpp|inl|py|sh|ts|txt|md)([^A-Za-z0-9_]|$)/)) {
        name = substr(rest, RSTART, RLENGTH)
        sub(/[^A-Za-z0-9_]$/, "", name)
        rest = substr(rest, RSTART + RLENGTH)
        if (name !~ /</ && !(name in is_end) && !(name in is_strange)) complain("file " name)
      }
      n = split(text, parts, /[^A-Za-z0-9_]+/)
      for (i = 1; i <= n; ++i)
        if (parts[i] ~ (is_code ? in_code : in_span))
          if (!(parts[i] in is_word) && !(parts[i] in is_strange)) complain("identifier " parts[i])
    }
    END { exit bad }' "$work/files" "$work/words" "$work/options" <(of_kind span) <(of_kind code) || bad=1
}

# "docs/theory/bulk.md, section 3" and "section 3 of docs/theory/bulk.md", in pages and in comments of the code.
check_sections() {
  local place page number
  while read -r place page number; do
    page=$(grep -E "^docs/(.*/)?$page$" "$work/files" | head -1)
    grep -q "^## $number\. " "$page" || complain "$place: $page has no section $number"
  done < <(grep -E '^(rigor|apps|tests|docs)/.*\.(hpp|cpp|inl|md)$|^README.md$' "$work/files" | xargs awk '
    function flush(   found, numbers, n, i) {
      while (match(text, /[a-z_]+\.md\)?,? (sections?|§) ?[0-9]+((,| and) §?[0-9]+)*|section [0-9]+ of [a-z_\/]+\.md/)) {
        found = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        match(found, /[a-z_]+\.md/)
        page = substr(found, RSTART, RLENGTH)
        sub(/[a-z_]+\.md/, "", found)
        n = split(found, numbers, /[^0-9]+/)
        for (i = 1; i <= n; ++i) if (numbers[i] != "") print file, page, numbers[i]
      }
      text = ""
    }
    FNR == 1 { flush(); file = FILENAME }
    { line = $0; sub(/^[ \/*]*/, "", line); text = text " " line }
    END { flush() }')
}

# The rooms of rigor/ have a line in docs/architecture.md, the scenes one in docs/gallery.md, the decisions one in their index.
check_lists() {
  local scene decision
  awk "/^rooms='/ { on = 1; next } /^'/ { on = 0 }
    on { sub(/:/, \"\"); for (i = 2; i <= NF; ++i) if (\$i != \".\") print \$1 \"/\" \$i }" tools/check_layers.sh >"$work/rooms"
  grep -oE '^\| `[a-z_]+/[a-z0-9_]+` ' docs/architecture.md | tr -d '|` ' | diff - "$work/rooms" >"$work/difference" ||
    complain "docs/architecture.md and tools/check_layers.sh have other rooms: $(grep '^[<>]' "$work/difference")"
  grep '^|' docs/gallery.md |
    grep -oE '`[a-z0-9_]+`' | tr -d '`' >"$work/scenes"
  for scene in scenes/*.yaml; do
    scene=$(basename "$scene" .yaml)
    grep -qx "$scene" "$work/scenes" || complain "docs/gallery.md: no row of scene $scene"
  done
  for scene in $(cat "$work/scenes"); do
    [ -e "scenes/$scene.yaml" ] || complain "docs/gallery.md: no scene scenes/$scene.yaml"
  done
  for decision in docs/decisions/[0-9]*.md; do
    decision=$(basename "$decision")
    grep -q "($decision)" docs/decisions/README.md || complain "docs/decisions/README.md: no line of $decision"
  done
}

# Every choice of a method is on the page of the methods.
check_methods() {
  local choice
  for choice in $("$program" methods | sed -nE 's/^  ([a-z0-9][a-z0-9-]*) .*/\1/p'); do
    grep -qw -- "$choice" docs/methods.md || complain "docs/methods.md: does not name the method $choice"
  done
}

# The version is the same wherever it stands.
check_version() {
  local version
  version=$(sed -nE 's/^project\(rigor VERSION ([0-9.]+) .*/\1/p' CMakeLists.txt)
  grep -q "version = \"$version\";" rigor/io/files/version.hpp || complain "rigor/io/files/version.hpp: not $version"
  grep -qx "version: $version" CITATION.cff || complain "CITATION.cff: not $version"
  grep -m1 '^## ' CHANGELOG.md | grep -qE "^## ($version |Not yet released$)" ||
    complain "CHANGELOG.md: does not begin with $version"
}

# --- Commands ---------------------------------------------------------------------------------------------------------

# What stands for words in capitals: pattern, then what the command is run with.
fillings='
s/SCENE\|run\.h5/run.h5/
s/SCENE\.\.\./example.yaml/
s/MESH\|SCENE|MESH|\bIN\b/l.obj/
s/SCENE|\bscene\.yaml/example.yaml/
s/RUN\.h5/run.h5/
s/OUT\.(yaml|obj)/made.\1/
s/-o OUT\b/-o made.csv/
s/scenes\/NAME/scenes\/ramp_slide/
s/KEY=a,b,c/run.step=0.01,0.005/
s/\b(BODY_A|A) (BODY_B|B)\b/floor ball/
s/\bBODY_A\b/ball/
s/X,Y,Z DX,DY,DZ/0,0,9 0,0,-1/
s/X,Y,Z/0,0,-1/
s/--closest K/--closest 1/
'

# Files that commands of the pages read: a scene, an L of three cubes as a mesh, and what pages define as `NAME.yaml`.
make_examples() {
  ln -s "$root/scenes" "$work/run/scenes"
  mkdir -p "$work/run/docs/img"
  cat >"$work/run/example.yaml" <<'YAML'
rigor: 1
name: example
run: {duration: 0.6, output_interval: 0.05}
materials: [{name: steel, friction: 0.3, restitution: 0.5}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: steel}]}
  - {name: ball, position: [0, 0, 0.1], velocity: [1, 0, -1], shapes: [{type: sphere, radius: 0.1, material: steel}]}
  - {name: arm, position: [3, 0, 2], shapes: [{type: box, size: [0.4, 0.1, 0.1], material: steel}]}
joints: [{name: elbow, type: hinge, bodies: [world, arm], anchor: [2.8, 0, 2], axis: [0, 1, 0]}]
YAML
  printf 'v %s\n' '0 0 0' '2 0 0' '2 1 0' '1 1 0' '1 2 0' '0 2 0' '0 0 1' '2 0 1' '2 1 1' '1 1 1' '1 2 1' '0 2 1' \
    >"$work/run/l.obj"
  printf 'f %s\n' '6 5 4 3 2 1' '7 8 9 10 11 12' '1 2 8 7' '2 3 9 8' '3 4 10 9' '4 5 11 10' '5 6 12 11' '6 1 7 12' \
    >>"$work/run/l.obj"
  awk -v to="$work/run/" '
    FNR == 1 { name = ""; seen = 0 }
    match($0, /`[a-z]+\.yaml`:$/) { name = substr($0, RSTART + 1, RLENGTH - 3); seen = 0; next }
    name != "" && /^    / { print substr($0, 5) >(to name); seen = 1; next }
    name != "" && seen && !/^$/ { name = "" }' "${pages[@]}"
  "$program" run "$work/run/example.yaml" -o "$work/kept.h5" --quiet
  "$program" study "$root/scenes/studies/slide_distance.yaml" --no-journal -o "$work/kept_study.h5" --quiet
}

# Command lines `place TAB command`: code blocks that begin with a command, without what is said beside it, and spans.
list_commands() {
  local start='(build/release/)?rigor(_[a-z_]+)? |make [a-z]|tools/[a-z_]+\.|cmake |ctest '
  { of_kind code | sed -E 's/\t\$ /\t/; s/ {3,}.*//; s/  # .*//'; of_kind span | sed 's/\\|/|/g'; } |
    grep -E $'\t'"($start)" | sort -u
}

# Options of a command line are options of the command, of the tool or of the benchmark.
check_options() {
  local place=$1 command=$2 of=$3 option
  for option in $(sed -E "s/\"[^\"]*\"|'[^']*'//g" <<<"$command" | grep -oE '(^| |\[)-(-[A-Za-z][a-z0-9-]*|o\b)' | tr -d ' ['); do
    grep -qxF -- "$of $option" "$work/options" || complain "$place: \`$command\`: no option $option"
  done
}

# Runs a command line of the program; for a short time, unless what it prints is on the page.
run_program() {
  local place=$1 command=$2 expected=$work/expected line code=0
  expected_output "$place" >"$expected"
  cp "$work/kept.h5" "$work/run/run.h5"
  cp "$work/kept_study.h5" "$work/run/runs.h5"
  if [ ! -s "$expected" ]; then
    case $command in
      *--duration*) ;;
      'rigor run '* | 'rigor compare '*) command+=' --duration 0.01' ;;
      'rigor render '*--time*) ;;
      'rigor render '*) command+=' --size 64x36' ;;
    esac
  fi
  (cd "$work/run" && bash -c "$command") >"$work/output" 2>"$work/errors" </dev/null || code=$?
  [ $code = 0 ] || [ -s "$expected" ] || complain "$place: \`$command\` ends with $code: $(head -3 "$work/errors")"
  while IFS= read -r line; do
    complain "$place: \`$command\` does not print: $line"
  done < <(missing_lines "$work/output" "$expected")
}

# Lines of the second file that the first lacks, word by word: numbers agree to a millionth, `...` stands for the rest of
# a line, and what follows two spaces and a # is the page's own remark.
missing_lines() {
  awk '
    function is_number(word) { return word ~ /^[+-]?[0-9]+(\.[0-9]*)?(e[+-]?[0-9]+)?$/ }
    function agree(a, b,   size) {
      if (a == b) return 1
      if (!is_number(a) || !is_number(b)) return 0
      size = (a < 0 ? -a : +a) + (b < 0 ? -b : +b)
      return a - b <= 1e-6 * size + 1e-9 && b - a <= 1e-6 * size + 1e-9
    }
    function matches(line, wanted,   n, m, k, words, others) {
      n = split(line, words, /[][, ]+/)
      m = split(wanted, others, /[][, ]+/)
      for (k = 1; k <= m; ++k) {
        if (others[k] == "...") return 1
        if (k > n || !agree(words[k], others[k])) return 0
      }
      return k > n
    }
    NR == FNR { sub(/ +$/, ""); printed[++count] = $0; next }
    { wanted = $0; sub(/  +# .*/, "", wanted); sub(/ +$/, "", wanted)
      for (i = 1; i <= count; ++i) if (matches(printed[i], wanted)) next
      print $0 }' "$1" "$2"
}

# Lines of a code block below the command at a place, up to an empty line that no more lines follow.
expected_output() {
  awk -F '\t' -v place="$1" '
    $2 == "code" { split($1, at, ":") }
    $1 == place && $3 ~ /^\$ / { page = at[1]; line = at[2] + 0; next }
    page != "" && $2 == "code" && at[1] == page && at[2] - line <= 2 && $3 !~ /^\$ / { print $3; line = at[2] + 0; next }
    page != "" { exit }' "$work/pages"
}

check_command() {
  local place=$1 command=${2#build/release/} word filled
  case $command in
    'make '*) word=${command#make }; grep -qE "^${word%% *}:" Makefile || complain "$place: no target $command"; return ;;
    tools/*) word=${command%% *}; [ -x "$word" ] || complain "$place: no tool $word"
      check_options "$place" "${command%%;*}" tool; return ;;
    cmake\ * | ctest\ *)
      word=$(grep -oE -- '--preset [a-z]+' <<<"$command" | cut -d' ' -f2) || return 0
      grep -q "\"name\": \"$word\"" CMakePresets.json || complain "$place: no preset $word"; return ;;
    rigor_*) word=${command%% *}; grep -rqw "$word" benchmarks/CMakeLists.txt || complain "$place: no program $word"
      check_options "$place" "${command%%;*}" tool; return ;;
  esac
  word=$(cut -d' ' -f2 <<<"$command")
  grep -q "^$word " "$work/options" || { complain "$place: no command rigor $word"; return; }
  check_options "$place" "$command" "$word"
  filled=$(sed -E "$fillings" <<<"$command")
  # A synopsis has brackets or dots outside of quotes; words without a file are a command's name, not a command line.
  [ "$word" != view ] || return 0
  [[ $(sed -E "s/\"[^\"]*\"//g" <<<"$filled") != *[][\|]* && $filled != *...* ]] || return 0
  [[ $filled =~ \.(yaml|h5|obj|json)( |$) || $filled == 'rigor methods' || $filled == *--K* ]] || return 0
  run_program "$place" "$filled"
}

check_commands() {
  local place command
  mkdir "$work/run" "$work/bin"
  ln -s "$program" "$work/bin/rigor"
  # Films need no ffmpeg here: pictures go in, and nobody looks at what comes out.
  printf '#!/bin/sh\ncat >/dev/null\n' >"$work/bin/ffmpeg"
  chmod +x "$work/bin/ffmpeg"
  PATH=$work/bin:$PATH
  make_examples
  while IFS=$'\t' read -r place command <&3; do check_command "$place" "$command"; done 3< <(list_commands)
}

list_files >"$work/files"
list_words >"$work/words"
list_options >"$work/options"
read_pages >"$work/pages"
check_links
check_names
check_sections
check_lists
check_methods
check_version
check_commands
[ $bad = 0 ] && echo "docs: what ${#pages[@]} pages name is there, and their $(list_commands | wc -l) commands are right"
exit $bad
