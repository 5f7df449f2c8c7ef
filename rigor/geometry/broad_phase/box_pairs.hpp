#pragma once

#include "rigor/geometry/shape/aabb.hpp"

#include <array>
#include <vector>

namespace rigor {

/// All pairs i < j of boxes that overlap or touch, in ascending order. The set is halved along its longest
/// side again and again: O(n log n + pairs) for boxes that are small compared with their distances.
std::vector<std::array<int, 2>> overlapping_pairs(const std::vector<Aabb>& boxes);

}  // namespace rigor
