#!/usr/bin/env bash
# What a new user does after `make python`: installs the wheel with pip, without a network, into a place of its own, and runs
# five lines that load a scene, run it and draw a plot (where matplotlib is there).
# usage: tests/package/check_python.sh BUILD SOURCE
set -euo pipefail
build=$(realpath "$1")
source=$(realpath "$2")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python=${PYTHON:-python3}

# The wheel of the module that is built, made as `make python` makes it.
version=$(sed -n 's/^project(.*VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")
wheel=$("$python" "$source/python/make_wheel.py" "$build/python/rigor" "$work/wheels" "$version" | tail -1)
if "$python" -m pip --version >/dev/null 2>&1; then
  "$python" -m pip install --quiet --no-index --no-deps --target "$work/site" "$wheel"
else
  "$python" -m zipfile -e "$wheel" "$work/site"
fi

plot=$("$python" -c 'import matplotlib' 2>/dev/null && echo yes || true)
cat >"$work/five_lines.py" <<END
import rigor
scene = rigor.load("$source/scenes/bouncing_ball.yaml")
run = rigor.run(scene, duration=2)
print(run.position["ball"][-1], run.audit.ok)
END
[ -z "$plot" ] || echo 'run.plot("energy").get_figure().savefig("energy.png")' >>"$work/five_lines.py"
(cd "$work" && PYTHONPATH="$work/site" MPLBACKEND=Agg "$python" -B five_lines.py) | tee "$work/said"
grep -q 'True$' "$work/said" || { echo "the audit of the run is not whole"; exit 1; }
[ -z "$plot" ] || "$python" - "$work/energy.png" <<'END'
import sys
import matplotlib.image
picture = matplotlib.image.imread(sys.argv[1])
assert picture.shape[0] > 100 and picture[..., :3].std() > 0.01, "the plot is empty"
END
echo "wheel, five lines${plot:+, a plot}"
