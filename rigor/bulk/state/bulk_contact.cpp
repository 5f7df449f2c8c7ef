#include "rigor/bulk/state/bulk_contact.hpp"

#include "rigor/core/index.hpp"

namespace rigor {

double BulkContact::normal_impulse() const {
  double sum = 0;
  for (std::size_t k = 0; k < at(point_count); ++k) sum += points[k].normal_impulse;
  return sum;
}

}  // namespace rigor
