#pragma once

#include "rigor/io/scene/object_reader.hpp"

namespace rigor {

/// Position [m] of an object with pose keys; by default the origin.
Vec3 read_position(const ObjectReader& object);

/// Orientation from one of the keys `orientation`, `rpy` and `axis_angle`; by default the identity.
Quat read_orientation(const ObjectReader& object);

}  // namespace rigor
