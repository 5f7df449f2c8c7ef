#!/usr/bin/env bash
# Holds the layers of docs/architecture.md: a folder of rigor/ includes itself and the layers below it, nothing
# up or across; and that no two headers define a type of the same name. Prints each offence and fails.
set -euo pipefail
cd "${1:-.}"

declare -A allowed=(
  [core]="core"
  [math]="core math"
  [geometry]="core math geometry"
  [solver]="core math solver"
  [model]="core math geometry model"
  [dynamics]="core math geometry solver model dynamics"
  [contact]="core math geometry solver model dynamics contact"
  [bulk]="core math geometry solver model dynamics bulk"
  [sim]="core math geometry solver model dynamics contact bulk sim"
  [io]="core math geometry model dynamics sim io"
  [view]="core math geometry model dynamics sim io view"
)

bad=0
for folder in rigor/*/; do
  layer=$(basename "$folder")
  if [ -z "${allowed[$layer]:-}" ]; then
    echo "rigor/$layer: not a layer of docs/architecture.md"; bad=1; continue
  fi
  while IFS=: read -r file line text; do
    [ -n "$file" ] || continue
    target=$(sed -E 's|.*"rigor/([a-z]+)/.*|\1|' <<<"$text")
    case " ${allowed[$layer]} " in
      *" $target "*) ;;
      *) echo "$file:$line: $layer may not include rigor/$target/"; bad=1 ;;
    esac
  done < <(grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"rigor/' -r "$folder" --include='*.hpp' --include='*.cpp' || true)
  if grep -nE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' -r "$folder" --include='*.hpp' --include='*.cpp' | grep -v '"rigor/'; then
    echo "rigor/$layer: include paths start at the repository root: \"rigor/...\""; bad=1
  fi
done
# The linker merges what has the same name: a type of namespace rigor is defined in one header only.
twice=$(find rigor -name '*.hpp' -exec awk '
  /^namespace [a-z:]+ \{/ { inner = $2 != "rigor" }
  /^}  \/\/ namespace/ { inner = 0 }
  !inner && /^(struct|class) .*[{:]/ { print $2 ~ /^alignas/ ? $3 : $2 }' {} + | sort | uniq -d)
if [ -n "$twice" ]; then
  echo "types with two definitions: $twice"; bad=1
fi
[ $bad = 0 ] && echo "layers: every include goes down"
exit $bad
