import pathlib

import pytest

import rigor


@pytest.fixture
def scenes():
    return pathlib.Path(__file__).parents[2] / "scenes"


@pytest.fixture
def ball():
    """A ball that falls 0.9 m and bounces."""
    return rigor.Scene(
        name="ball",
        run={"duration": 1, "step": 0.01, "output_interval": 0.01},
        materials=[{"name": "rubber", "restitution": 0.8}],
        bodies=[{"name": "floor", "motion": "static",
                 "shapes": [{"type": "plane", "normal": [0, 0, 1], "offset": 0, "material": "rubber"}]},
                {"name": "ball", "position": [0, 0, 1], "mass": 1,
                 "shapes": [{"type": "sphere", "radius": 0.1, "material": "rubber"}]}])


@pytest.fixture
def wheel():
    """A wheel of 0.09 kg m² on a hinge, without gravity."""
    return rigor.Scene(
        world={"gravity": [0, 0, 0]}, run={"step": 0.01},
        bodies=[{"name": "wheel", "position": [0, 2, 1], "mass": 2,
                 "shapes": [{"type": "cylinder", "radius": 0.3, "length": 0.1}]}],
        joints=[{"name": "axle", "type": "hinge", "bodies": ["world", "wheel"], "anchor": [0, 2, 1],
                 "axis": [0, 0, 1]}])
