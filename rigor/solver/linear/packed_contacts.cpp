#include "rigor/solver/linear/packed_contacts.hpp"

#include "rigor/solver/linear/two_doubles.hpp"

#include <algorithm>

namespace rigor {

using Eigen::Index;

PackedContacts::PackedContacts(const ContactRows& rows) : size_(6 * static_cast<Index>(rows.node_count())) {
  sides_.reserve(2 * rows.contacts.size());
  ends_.reserve(rows.contacts.size());
  for (const ContactRows::Sides& sides : rows.contacts) {
    for (const ContactRows::Side& side : sides) {
      if (side.node < 0) continue;
      Side& packed = sides_.emplace_back();
      packed.node = 6 * static_cast<std::ptrdiff_t>(side.node);
      std::copy_n(side.J.data(), 18, packed.rows.begin());
      for (std::size_t c = 0; c < 6; ++c) {
        for (std::size_t r = 0; r < 3; ++r) packed.columns[4 * c + r] = packed.rows[6 * r + c];
        packed.columns[4 * c + 3] = 0;
      }
    }
    ends_.push_back(sides_.size());
  }
}

void PackedContacts::rates(const VecX& V, VecX& rates) const {
  rates.resize(3 * static_cast<Index>(ends_.size()));
  const Side* side = sides_.data();
  double* w = rates.data();
  for (const std::size_t end : ends_) {
    TwoDoubles tangents{}, normal{};
    for (; side != sides_.data() + end; ++side) {
      const double *J = side->columns.data(), *v = V.data() + side->node;
      for (int c = 0; c < 6; ++c, J += 4) {
        tangents += v[c] * two_of(J);
        normal += v[c] * two_of(J + 2);
      }
    }
    put_two(tangents, w);
    w[2] = normal[0];
    w += 3;
  }
}

void PackedContacts::wrenches(const VecX& lambda, VecX& wrenches) const {
  wrenches.setZero(size_);
  const Side* side = sides_.data();
  const double* force = lambda.data();
  for (const std::size_t end : ends_) {
    const double t = force[0], s = force[1], n = force[2];
    force += 3;
    // Many contacts are open.
    if (t == 0 && s == 0 && n == 0) side = sides_.data() + end;
    for (; side != sides_.data() + end; ++side) {
      const double* J = side->rows.data();
      double* p = wrenches.data() + side->node;
      for (int c = 0; c < 6; c += 2)
        put_two(two_of(p + c) + (t * two_of(J + c) + (s * two_of(J + 6 + c) + n * two_of(J + 12 + c))),
                p + c);
    }
  }
}

}  // namespace rigor
