#include "rigor/geometry/exact/planar_turns.hpp"

#include "rigor/geometry/exact/orientation.hpp"

#include <array>
#include <cstddef>

namespace rigor {

int turns_about(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const std::array<const Vec2*, 4> corners = {&a, &b, &c, &a};
  int turns = 0;
  // Crossing count: an edge that crosses the horizontal ray from p to the right counts +1 upwards and -1
  // downwards. Half-open intervals in y count a vertex on the ray once.
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 &u = *corners[i], &v = *corners[i + 1];
    const bool is_upward = u.y() <= p.y() && p.y() < v.y();
    const bool is_downward = v.y() <= p.y() && p.y() < u.y();
    if (is_upward && orientation(u, v, p) > 0) ++turns;
    if (is_downward && orientation(v, u, p) > 0) --turns;
  }
  return turns;
}

}  // namespace rigor
