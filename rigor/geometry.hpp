#pragma once

// Shapes and meshes and what can be asked of them, without bodies and forces: distance and penetration,
// contacts, rays, pushed shapes, mass and inertia, time of first contact. The CMake component `geometry` has
// all of it (docs/cpp.md).

#include "rigor/core/input_error.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/distance/point_distance.hpp"
#include "rigor/geometry/mass/mass_properties.hpp"
#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/motion/shape_cast.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"
#include "rigor/math/rotation.hpp"
