"""The compiled part of the package: what it has is offered by rigor and rigor.geometry."""

from collections.abc import Callable
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._simulation import Audit
from .geometry import Shape

__version__: str

class InputError(ValueError):
    """Wrong input: what is wrong, where, and what is allowed; messages lists all of it."""
    messages: list[str]

class SimulationStopped(RuntimeError):
    """The engine could not continue: when, and why."""

class SceneData:
    @property
    def name(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def step(self) -> float: ...
    @property
    def duration(self) -> float: ...
    @property
    def output_interval(self) -> float: ...
    @property
    def bodies(self) -> list[str]: ...
    @property
    def masses(self) -> npt.NDArray[np.float64]: ...
    @property
    def joints(self) -> list[tuple[str, int]]: ...

class TextScene:
    def __init__(self, text: str, file_name: str, folder: str, overrides: list[str]) -> None: ...
    @property
    def scene(self) -> SceneData: ...

class Record:
    @property
    def time(self) -> npt.NDArray[np.float64]: ...
    @property
    def position(self) -> npt.NDArray[np.float64]: ...
    @property
    def orientation(self) -> npt.NDArray[np.float64]: ...
    @property
    def velocity(self) -> npt.NDArray[np.float64]: ...
    @property
    def angular_velocity(self) -> npt.NDArray[np.float64]: ...
    @property
    def kinetic(self) -> npt.NDArray[np.float64]: ...
    @property
    def potential(self) -> npt.NDArray[np.float64]: ...
    @property
    def elastic(self) -> npt.NDArray[np.float64]: ...
    @property
    def penetration(self) -> npt.NDArray[np.float64]: ...
    @property
    def joint_coordinate(self) -> npt.NDArray[np.float64]: ...
    @property
    def joint_rate(self) -> npt.NDArray[np.float64]: ...
    @property
    def events(self) -> list[Event]: ...
    def audit_json(self) -> str: ...
    def violations(self) -> list[str]: ...

def record(scene: TextScene, duration: Optional[float], output_interval: Optional[float], threads: int, separate: bool, files: list[str], progress: Any) -> Record: ...

class Event:
    """Something that happened at an instant."""
    @property
    def kind(self) -> str:
        """'impact', 'rest', 'separation' or 'slip_to_stick'."""
    @property
    def time(self) -> float:
        """[s]."""
    @property
    def body_a(self) -> int:
        """Index of a body."""
    @property
    def body_b(self) -> int:
        """Index of the other; -1: none."""
    @property
    def point(self) -> npt.NDArray[np.float64]:
        """Where an impact was [m]."""
    @property
    def impulse(self) -> npt.NDArray[np.float64]:
        """Impulse of an impact on body_b [N s]."""

class Contact:
    """A point where two bodies touch."""
    @property
    def body_a(self) -> int:
        """Index of a body."""
    @property
    def body_b(self) -> int:
        """Index of the other, larger than body_a."""
    @property
    def point(self) -> npt.NDArray[np.float64]:
        """Where [m]."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Unit, from body_a to body_b."""
    @property
    def gap(self) -> float:
        """[m], negative when overlapping."""
    @property
    def force(self) -> npt.NDArray[np.float64]:
        """On body_b [N]."""
    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """Of body_b against body_a [m/s]."""
    @property
    def mode(self) -> str:
        """'open', 'stick', 'slide' or 'unknown'."""

class JointState:
    """A joint at an instant."""
    @property
    def joint(self) -> int:
        """Index of the joint."""
    @property
    def coordinates(self) -> npt.NDArray[np.float64]:
        """[rad] or [m]."""
    @property
    def rates(self) -> npt.NDArray[np.float64]:
        """[rad/s] or [m/s]."""
    @property
    def efforts(self) -> npt.NDArray[np.float64]:
        """Of motors and servos [N m] or [N]."""
    @property
    def anchor(self) -> npt.NDArray[np.float64]:
        """On the second body [m]."""
    @property
    def force(self) -> npt.NDArray[np.float64]:
        """Reaction on the second body [N]."""
    @property
    def torque(self) -> npt.NDArray[np.float64]:
        """The same about the anchor [N m]."""

class RayHit:
    """Where a ray meets a body."""
    @property
    def body(self) -> int:
        """Index of the body."""
    @property
    def fraction(self) -> float:
        """Of the direction's length."""
    @property
    def point(self) -> npt.NDArray[np.float64]:
        """[m]."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Outward, unit."""

class CastHit:
    """Where a shape that is pushed meets a body."""
    @property
    def body(self) -> int:
        """Index of the body."""
    @property
    def fraction(self) -> float:
        """Of the way, which is proven free so far."""
    @property
    def point(self) -> npt.NDArray[np.float64]:
        """[m]."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """From the shape to the body, unit."""

class Simulation:
    def __init__(self, scene: SceneData, separate: bool = False) -> None: ...
    def save(self) -> bytes:
        """All there is, as bytes: restore() continues with the same bits."""
    def restore(self, data: bytes) -> None:
        """Continues from the bytes of save(), of a simulation of the same scene."""
    def copy(self) -> Simulation:
        """An independent simulation that continues with the same bits, without the controller."""
    def audit(self) -> Audit:
        """How far the run so far can be trusted, as an Audit."""
    def step(self) -> None:
        """Advances by one step, `run.step` of the scene."""
    def advance_to(self, t: float) -> None:
        """Advances to t [s]. Ctrl-C ends it; the simulation stays at the last control instant."""
    def reset(self) -> None:
        """Returns to t = 0."""
    @property
    def time(self) -> float:
        """[s]."""
    @property
    def step_length(self) -> float:
        """[s]."""
    @property
    def body_count(self) -> int: ...
    @property
    def joint_count(self) -> int: ...
    def body(self, name: str) -> int:
        """Index of a body, which is quicker than its name."""
    def joint(self, name: str) -> int:
        """Index of a joint."""
    @property
    def body_names(self) -> list[str]: ...
    @property
    def joint_names(self) -> list[str]: ...
    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """Origins of the bodies' frames (n x 3) [m]: a view that is refreshed each time it is asked for."""
    @property
    def orientations(self) -> npt.NDArray[np.float64]:
        """Quaternions w, x, y, z (n x 4), likewise."""
    @property
    def velocities(self) -> npt.NDArray[np.float64]:
        """Of the centres of mass (n x 3) [m/s], likewise."""
    @property
    def angular_velocities(self) -> npt.NDArray[np.float64]:
        """In the world (n x 3) [rad/s], likewise."""
    def pose(self, body: str | int) -> npt.NDArray[np.float64]:
        """Position and quaternion w, x, y, z (7)."""
    def position(self, body: str | int) -> npt.NDArray[np.float64]:
        """[m]."""
    def velocity(self, body: str | int) -> npt.NDArray[np.float64]:
        """Of the centre of mass [m/s]."""
    def angular_velocity(self, body: str | int) -> npt.NDArray[np.float64]:
        """[rad/s]."""
    def is_asleep(self, body: str | int) -> bool:
        """Whether it sleeps (method.sleeping)."""
    def apply_force(self, body: str | int, force: npt.ArrayLike, point: npt.ArrayLike | None = None) -> None:
        """A force [N] until the end of the next step, at the centre of mass or at a point [m]."""
    def apply_torque(self, body: str | int, torque: npt.ArrayLike) -> None:
        """A torque [N m] until the end of the next step."""
    def apply_impulse(self, body: str | int, impulse: npt.ArrayLike, point: npt.ArrayLike | None = None) -> None:
        """An impulse [N s], at once."""
    def apply_angular_impulse(self, body: str | int, impulse: npt.ArrayLike) -> None:
        """An angular impulse [N m s], at once."""
    def set_pose(self, body: str | int, pose: npt.ArrayLike | None) -> None:
        """Puts a dynamic or kinematic body there at once."""
    def set_velocity(self, body: str | int, velocity: npt.ArrayLike, angular_velocity: npt.ArrayLike = ...) -> None:
        """Sets the velocities of a dynamic or kinematic body [m/s], [rad/s]."""
    def move_to(self, body: str | int, pose: npt.ArrayLike | None, duration: float) -> None:
        """Leads a kinematic body there, in so long [s]."""
    def set_motor_velocity(self, joint: str | int, velocity: float, max_force: float = float("inf"), coordinate: int = 0) -> None:
        """A motor that holds a rate [rad/s] or [m/s], as far as its force [N m] or [N] goes."""
    def set_motor_effort(self, joint: str | int, effort: float, coordinate: int = 0) -> None:
        """A motor that gives this torque [N m] or force [N] on the second body."""
    def set_motor_position(self, joint: str | int, target: float, stiffness: float, damping: float, coordinate: int = 0, max_force: float = ...) -> None:
        """A servo: -stiffness (coordinate - target) - damping (rate), at most max_force [N m] or [N]."""
    def release_motor(self, joint: str | int, coordinate: int = 0) -> None:
        """The laws of the scene hold again."""
    def set_gravity(self, gravity: npt.ArrayLike) -> None:
        """[m/s²]."""
    def set_friction(self, material: str, friction: float) -> None:
        """Of a material."""
    def set_restitution(self, material: str, restitution: float) -> None:
        """Of a material."""
    def set_controller(self, controller: Callable[[Simulation], None] | None, period: float = 0.0) -> None:
        """Calls controller(simulation) at every multiple of the period [s] (0: of the step) before the motion goes on; None ends it."""
    def contacts(self) -> list[Contact]:
        """Points that touch, with their forces, as a list of Contact."""
    def joint_motion(self, joint: str | int) -> JointState:
        """Coordinates and rates of a joint, without forces."""
    def joint_forces(self, joint: str | int) -> JointState:
        """The same with reaction and efforts, which are costly."""
    def take_events(self) -> list[Event]:
        """Events since the last call, as a list of Event."""
    @property
    def energy(self) -> float:
        """Mechanical energy, without the potential of forces that are applied [J]."""
    def ray(self, origin: npt.ArrayLike, direction: npt.ArrayLike, max_fraction: float = float("inf")) -> Optional[RayHit]:
        """The first surface that a ray crosses, as a RayHit, or None."""
    def nearest(self, point: npt.ArrayLike | None, k: int = 1) -> list[tuple[int, float]]:
        """The k bodies nearest to a point: pairs of index and signed distance [m]."""
    def cast(self, shape: Shape, pose: npt.ArrayLike | None, way: npt.ArrayLike) -> Optional[CastHit]:
        """The first body that a shape meets which is pushed along a way [m], as a CastHit, or None."""
    def overlapping(self, shape: Shape, pose: npt.ArrayLike | None) -> list[int]:
        """Indices of the bodies that a shape touches or overlaps there."""

class Batch:
    def __init__(self, scene: SceneData, count: int, threads: int = 0) -> None: ...
    def __len__(self) -> int: ...
    @property
    def threads(self) -> int: ...
    def step(self) -> None:
        """One step of every world."""
    def advance_to(self, t: float) -> None:
        """Advances every world to t [s]."""
    def world(self, index: int) -> Simulation:
        """A world, as a Simulation."""
    @property
    def stops(self) -> list[str]:
        """Why each world has stopped; empty where it has not."""
    @property
    def states(self) -> npt.NDArray[np.float64]:
        """Position, quaternion w x y z, velocity, angular velocity (worlds x bodies x 13): a view that is refreshed each time it is asked for."""
    def apply_forces(self, body: str, forces: npt.ArrayLike) -> None:
        """A force [N] on a body in each world, until the next step ends."""
    def set_motor_efforts(self, joint: str, efforts: npt.ArrayLike, coordinate: int = 0) -> None:
        """Of a joint's motor in each world."""
    def joint_coordinates(self, joint: str, coordinate: int = 0) -> npt.NDArray[np.float64]:
        """In each world [rad] or [m]."""
    def joint_rates(self, joint: str, coordinate: int = 0) -> npt.NDArray[np.float64]:
        """In each world [rad/s] or [m/s]."""
    def set_controller(self, controller: Callable[[int, Simulation], None] | None, period: float = 0.0) -> None:
        """A function controller(index, world) called at every multiple of period [s] (0: of the step) before a world goes on; None ends it. The threads wait for each other in it."""
    def set_states(self, states: npt.ArrayLike) -> None:
        """Puts all bodies where `states` says, in its order; of a kinematic body the velocities are left out."""
    def set_frictions(self, material: str, frictions: npt.ArrayLike) -> None:
        """Of a material in each world."""
    def set_restitutions(self, material: str, restitutions: npt.ArrayLike) -> None:
        """Of a material in each world."""
    def set_gravities(self, gravities: npt.ArrayLike) -> None:
        """In each world [m/s²]."""
    @property
    def times(self) -> npt.NDArray[np.float64]:
        """Of each world [s]."""
    def reset(self, index: int | npt.ArrayLike) -> None:
        """Returns worlds to t = 0: one, a list of indices, or those where an array of flags is true."""

def student_quantile(share: float, degrees_of_freedom: float) -> float: ...

class StudyRecord:
    def __init__(self, file: str, threads: int, journal: str) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def parameters(self) -> dict[str, npt.NDArray[np.float64]]: ...
    @property
    def outcomes(self) -> dict[str, npt.NDArray[np.float64]]: ...
    @property
    def statuses(self) -> list[str]: ...
    @property
    def reasons(self) -> list[str]: ...
    @property
    def answer(self) -> str: ...
    @property
    def unmet(self) -> list[str]: ...
    def save(self, path: str) -> None: ...
