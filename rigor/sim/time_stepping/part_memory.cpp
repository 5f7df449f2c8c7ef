#include "rigor/sim/time_stepping/part_memory.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// Whether two lists of contacts, found at one instant, pose the same problem. What a model says of a pair,
/// and how surfaces bend, follows from the key and the points.
bool are_same(const std::vector<Contact>& a, const std::vector<Contact>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Contact& x, const Contact& y) {
    return x.key() == y.key() && x.point.gap == y.point.gap && x.point.p_WA == y.point.p_WA &&
           x.point.p_WB == y.point.p_WB && x.point.n_W == y.point.n_W;
  });
}

}  // namespace

const MovedPart& PartMemory::moved(double h, double theta, const Cluster& part,
                                   const std::function<MovedPart(const Cluster&)>& move) {
  const auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& other) {
    return other.h == h && other.theta == theta && other.part.bodies == part.bodies &&
           are_same(other.part.contacts, part.contacts);
  });
  if (known != known_.end()) return known->moved;
  known_.push_back({h, theta, part, move(part)});
  return known_.back().moved;
}

}  // namespace rigor
