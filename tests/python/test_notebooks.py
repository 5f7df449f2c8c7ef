"""The notebooks of docs/notebooks/: their code, cell after cell in an interpreter of its own. Each ends with assertions of what is known from
elsewhere. Cells tagged `plot` need matplotlib and are left out where it is absent.
"""

import importlib.util
import json
import os
import pathlib
import subprocess
import sys

import pytest

docs = pathlib.Path(__file__).parents[2] / "docs"
notebooks = sorted((docs / "notebooks").glob("*.ipynb"))

runner = """
import json, sys
path, plots = sys.argv[1:]
names = {"__name__": "__main__"}
for number, cell in enumerate(json.load(open(path, encoding="utf-8"))["cells"], 1):
    is_plot = "plot" in cell["metadata"].get("tags", [])
    if cell["cell_type"] == "code" and (plots == "plots" or not is_plot):
        exec(compile("".join(cell["source"]), f"cell {number}", "exec"), names)
"""


def test_there_are_five_and_the_documentation_has_them():
    page = (docs / "python.md").read_text()
    assert len(notebooks) >= 5
    for notebook in notebooks:
        assert f"(notebooks/{notebook.name})" in page


@pytest.mark.parametrize("notebook", notebooks, ids=lambda path: path.stem)
def test_a_notebook_finds_what_is_known(notebook, tmp_path):
    content = json.loads(notebook.read_text(encoding="utf-8"))
    assert (content["nbformat"], content["nbformat_minor"]) == (4, 5)
    code = [cell for cell in content["cells"] if cell["cell_type"] == "code"]
    assert "assert " in "".join(code[-1]["source"])
    assert notebook.stat().st_size < 50_000, "outputs are kept small"
    plots = "plots" if importlib.util.find_spec("matplotlib") else "no plots"
    ran = subprocess.run([sys.executable, "-c", runner, notebook, plots], cwd=tmp_path, capture_output=True, text=True,
                         env={**os.environ, "MPLBACKEND": "Agg"})
    assert ran.returncode == 0, ran.stderr
