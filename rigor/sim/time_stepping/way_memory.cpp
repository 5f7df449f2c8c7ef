#include "rigor/sim/time_stepping/way_memory.hpp"

#include "rigor/sim/time_stepping/part_memory.hpp"

namespace rigor {

void WayMemory::clear() {
  *this = WayMemory();
}

long WayMemory::number_of(int body) const {
  const auto place = numbers_.find(body);
  return place == numbers_.end() ? 1 : place->second;
}

void WayMemory::note(const Cluster& struck, const Cluster& end, double h) {
  // In another time all ways are others.
  const bool is_other = h != h_ || struck.bodies != struck_.bodies;
  if (is_other) {
    meetings_.clear();
    clear_until_.clear();
    at_end_.clear();
    numbers_.clear();
  }
  for (std::size_t i = 0; i < struck.bodies.size() && !is_other; ++i) {
    if (!is_same_phase(struck.phases[i], struck_.phases[i]) || !is_same_phase(end.phases[i], end_.phases[i]))
      numbers_[struck.bodies[i]] = number_of(struck.bodies[i]) + 1;
  }
  struck_ = struck;
  end_ = end;
  h_ = h;
}

}  // namespace rigor
