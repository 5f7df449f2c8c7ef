"""Rigid-body dynamics whose answers can be trusted, from Python.

    import rigor
    run = rigor.run(rigor.load("scene.yaml"), duration=5)
    print(run.position["ball"][-1], run.audit.violations)

All numbers are in SI units; quaternions are w, x, y, z; scenes have the keys of docs/scene.md.
docs/python.md is the tutorial.
"""

from ._rigor import Contact, Event, InputError, JointState, RayHit, SimulationStopped, __version__
from . import geometry
from ._run import Run, run
from ._scene import Scene, load
from ._simulation import Batch, Simulation
from ._study import Study, study
from ._vector_env import Box, VectorEnv

__all__ = ["Batch", "Box", "Contact", "Event", "InputError", "JointState", "RayHit", "Run", "Scene", "Simulation",
           "SimulationStopped", "Study", "VectorEnv", "geometry", "load", "run", "study", "__version__"]
