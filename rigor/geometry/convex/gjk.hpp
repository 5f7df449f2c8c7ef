#pragma once

#include "rigor/geometry/convex/minkowski.hpp"
#include "rigor/geometry/convex/simplex.hpp"

#include <array>
#include <limits>

namespace rigor {

/// State of the search for the point of the difference B - A nearest to the origin. Every separation and
/// every length seen is a bound: separation ≤ distance ≤ upper, to rounding.
struct GjkState {
  enum class Outcome {
    converged,  ///< upper - separation is within the tolerance, or the separation is enough.
    stalled,    ///< Rounding allows no further progress.
    touching    ///< The cores overlap, or are closer than rounding can tell.
  };
  Outcome outcome = Outcome::converged;
  std::array<DifferencePoint, 4> points;  ///< The first nearest.count of them carry the nearest point.
  SimplexPoint nearest;                   ///< Its indices are 0, 1, ...
  double upper = std::numeric_limits<double>::infinity();  ///< |nearest.v| [m].
  double separation =
      -std::numeric_limits<double>::infinity();  ///< Largest n · w of any support point seen [m].
  Vec3 n = Vec3::UnitX();                        ///< The unit direction of that separation, from A to B.
  int iterations = 0;
  double enough = std::numeric_limits<double>::infinity();  ///< A separation beyond it ends the search [m].
};

/// First support point of the search, along the line through the origins of the frames.
GjkState start_gjk(const CorePair& pair);

/// Iterates until upper - separation ≤ tolerance [m], until the separation is beyond what is enough, or until
/// no further progress is possible. May be called again with a smaller tolerance, and then continues.
///
/// Source: Gilbert, Johnson and Keerthi, A Fast Procedure for Computing the Distance Between Complex Objects
/// in Three-Dimensional Space, IEEE J. Robotics and Automation 4(2), 1988.
void advance_gjk(const CorePair& pair, double tolerance, GjkState& state);

}  // namespace rigor
