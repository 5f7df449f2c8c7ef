#pragma once

#include "rigor/model/model.hpp"

#include <memory>

namespace rigor::bench {

/// 2,000 hulls that fall on hills of 20,000 triangles.
std::shared_ptr<const Model> make_terrain();
/// 1,000 cylinders that fall into a pen.
std::shared_ptr<const Model> make_cylinders();
/// 1,000 ellipsoids that fall into a pen.
std::shared_ptr<const Model> make_ellipsoids();
/// 1,000 ellipsoids, cylinders, cones and capsules that fall on hills of 20,000 triangles.
std::shared_ptr<const Model> make_round_on_mesh();
/// 3,000 spheres, boxes, capsules and hulls that fall into a bin.
std::shared_ptr<const Model> make_bin();
/// 400 dolls of ten bodies, five ball joints and four hinges with limits, that fall on stairs.
std::shared_ptr<const Model> make_dolls();

}  // namespace rigor::bench
