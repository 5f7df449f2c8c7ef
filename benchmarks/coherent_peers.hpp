#pragma once

#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigor::bench {

/// Signed distance of two shapes that a library was given beforehand [m].
using DistanceQuery = std::function<double(const Pose& X_WA, const Pose& X_WB)>;

/// A library of Debian that computes signed distances of convex polyhedra.
struct DistancePeer {
  std::string name;
  std::function<DistanceQuery(const Convex& a, const Convex& b)> make_query;
};

/// Those that were installed when this was built.
std::vector<DistancePeer> distance_peers();

}  // namespace rigor::bench
