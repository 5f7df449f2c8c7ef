"""Shapes and what can be asked of them: distance, contacts, mass, rays, time of contact.

A pose is None, a position (3), position and quaternion w, x, y, z (7), or a 4 x 4 matrix. Lengths are full lengths.
"""

from ._rigor.geometry import (Distance, Shape, box, capsule, cone, contacts, convex, cylinder, distance, ellipsoid, mass,
                              mesh, plane, ray, sphere, time_of_contact)

__all__ = ["Distance", "Shape", "box", "capsule", "cone", "contacts", "convex", "cylinder", "distance", "ellipsoid",
           "mass", "mesh", "plane", "ray", "sphere", "time_of_contact"]
