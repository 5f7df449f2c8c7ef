"""Simulations and batches of them, on scenes of Python."""

import json

from . import _rigor
from ._scene import data_of


class Audit(dict):
    """How far a run can be trusted: the keys of docs/output.md."""

    def __init__(self, text, violations):
        super().__init__(json.loads(text))
        self.violations = violations
        """Quantities outside their tolerance; if there are none, the run can be trusted."""

    @property
    def ok(self):
        """Whether there are no violations."""
        return not self.violations


class Simulation(_rigor.Simulation):
    """A scene that runs step by step, in every scheme, while a program looks at it and acts on it.

    Bodies and joints are given by name or by index. It can be copied and pickled (without its controller).
    """

    def __init__(self, scene, separate=False):
        super().__init__(data_of(scene), separate)
        self.scene = scene.copy()

    def copy(self):
        """An independent simulation that continues with the same bits, without the controller."""
        return _restored(*self.__reduce__()[1])

    __copy__ = copy

    def __deepcopy__(self, memo):
        return self.copy()

    def __reduce__(self):
        return _restored, (self.scene, self.save())

    def __repr__(self):
        return f"<rigor.Simulation of {self.scene.name!r} at t = {self.time:g} s>"


def _restored(scene, data):
    simulation = Simulation(scene, True)
    simulation.restore(data)
    return simulation


class Batch(_rigor.Batch):
    """Many worlds that begin as the same scene and go their own ways, on several threads (0: all)."""

    def __init__(self, scene, count, threads=0):
        super().__init__(data_of(scene), count, threads)
        self.scene = scene.copy()
