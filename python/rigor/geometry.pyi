"""Shapes and what can be asked of them: distance, contacts, mass, rays, time of contact."""

from typing import Any, Optional

import numpy as np
import numpy.typing as npt

class Shape:
    """A shape in its own frame; full lengths in m."""

def sphere(radius: float) -> Shape: ...

def box(size: npt.ArrayLike) -> Shape:
    """Full lengths of the edges."""

def capsule(radius: float, length: float) -> Shape:
    """Along z; length of the cylindrical part."""

def cylinder(radius: float, length: float) -> Shape:
    """Along z."""

def cone(radius: float, length: float) -> Shape:
    """Along z, its apex at length / 2."""

def ellipsoid(radii: npt.ArrayLike) -> Shape: ...

def plane(normal: npt.ArrayLike, offset: float = 0.0) -> Shape:
    """All points with normal · p <= offset."""

def convex(points: npt.ArrayLike) -> Shape:
    """The convex hull of points (n x 3)."""

def mesh(vertices: npt.ArrayLike, triangles: npt.ArrayLike, may_be_open: bool = False) -> Shape:
    """Triangles (n x 3 indices), counter-clockwise seen from outside."""

class Distance:
    """Signed distance with the bounds that prove it."""
    @property
    def distance(self) -> float:
        """[m]; minus the depth of an overlap."""
    @property
    def lower(self) -> float:
        """Proven lower bound [m]."""
    @property
    def upper(self) -> float:
        """Proven upper bound [m]."""
    @property
    def point_a(self) -> npt.NDArray[np.float64]:
        """Witness point on a [m]."""
    @property
    def point_b(self) -> npt.NDArray[np.float64]:
        """Witness point on b [m]."""
    @property
    def normal(self) -> npt.NDArray[np.float64]:
        """Unit, from a to b."""
    def __float__(self) -> float: ...

def distance(a: Shape, b: Shape, pose_a: npt.ArrayLike | None = None, pose_b: npt.ArrayLike | None = None) -> Distance:
    """Signed distance of two shapes [m]."""

def contacts(a: Shape, b: Shape, pose_a: npt.ArrayLike | None = None, pose_b: npt.ArrayLike | None = None, tolerance: float = 1e-06) -> list:
    """All points closer than the tolerance [m], as dicts."""

def mass(shape: Shape, density: float = 1000.0) -> dict:
    """Mass [kg], centre of mass [m], inertia about it (3 x 3) [kg m²], as a dict."""

def time_of_contact(a: Shape, b: Shape, pose_a: npt.ArrayLike | None = None, pose_b: npt.ArrayLike | None = None, velocity_a: npt.ArrayLike = ..., angular_velocity_a: npt.ArrayLike = ..., velocity_b: npt.ArrayLike = ..., angular_velocity_b: npt.ArrayLike = ..., t_end: float = 1.0) -> Optional[float]:
    """First time in [0, t_end] at which the moving shapes touch [s], or None if they provably do not."""

def ray(shape: Shape, origin: npt.ArrayLike, direction: npt.ArrayLike, pose: npt.ArrayLike | None = None) -> list[tuple[float, npt.NDArray[np.float64]]]:
    """All crossings of a ray: pairs of fraction and point [m]."""
