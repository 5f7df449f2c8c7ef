#pragma once

#include "rigor/model/model.hpp"

#include <memory>

namespace rigor::bench {

/// A running bond of 40 rows of 60 bricks, one brick (0.25 m) thick; each brick moved along the wall and
/// across it by up to `jitter` [m] at random.
std::shared_ptr<const Model> make_wall(double jitter);
/// The same wall, which a ball of 4.2 t hits at 20 m/s.
std::shared_ptr<const Model> make_hit_wall();
/// A column of so many unit cubes.
std::shared_ptr<const Model> make_column(int cubes, double jitter);

}  // namespace rigor::bench
