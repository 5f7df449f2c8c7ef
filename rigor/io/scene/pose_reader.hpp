#pragma once

#include "rigor/io/scene/object_reader.hpp"

namespace rigor {

/// Position [m] of an object with pose keys; the origin by default.
Vec3 read_position(const ObjectReader& object);

/// Orientation by one of the keys `orientation`, `rpy` and `axis_angle`; the identity by default.
Quat read_orientation(const ObjectReader& object);

}  // namespace rigor
