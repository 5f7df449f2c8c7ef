#include "rigor/sim/bulk/bulk_arrays.hpp"

#include "rigor/core/index.hpp"

#include <cstddef>

namespace rigor {

namespace {

void append_row(const Vec3& row, std::vector<double>& rows) {
  rows.insert(rows.end(), row.data(), row.data() + 3);
}

void add_to_row(const Vec3& a, int row, std::vector<double>& rows) {
  Vec3::Map(&rows[3 * at(row)]) += a;
}

}  // namespace

ContactArrays contact_arrays(const std::vector<BulkContact>& contacts, double step) {
  ContactArrays arrays;
  for (const BulkContact& contact : contacts) {
    const double pressed = contact.normal_impulse();
    for (std::size_t k = 0; k < at(contact.point_count); ++k) {
      const BulkContact::Point& point = contact.points[k];
      const Vec3 friction = pressed > 0 ? Vec3(point.normal_impulse / pressed * contact.friction_impulse_W)
                                        : Vec3(Vec3::Zero());
      arrays.body_A.push_back(contact.body_A);
      arrays.body_B.push_back(contact.body_B);
      append_row(point.p_W, arrays.point);
      append_row(contact.n_W, arrays.normal);
      append_row((point.normal_impulse * contact.n_W + friction) / step, arrays.force);
      arrays.gap.push_back(point.gap);
    }
  }
  return arrays;
}

ContactLoads contact_loads(const std::vector<BulkContact>& contacts, const std::vector<Vec3>& centers,
                           double step) {
  ContactLoads loads{std::vector<double>(3 * centers.size(), 0), std::vector<double>(3 * centers.size(), 0)};
  for (const BulkContact& contact : contacts) {
    const Vec3 impulse = contact.impulse_W();
    // The moment about a body's centre: of each point's normal impulse, of friction in the middle, and of
    // what twists and rolls.
    const auto moment_about = [&](int body) {
      const Vec3& center = centers[at(body)];
      Vec3 moment = contact.friction_moment_W + (contact.center_W - center).cross(contact.friction_impulse_W);
      for (std::size_t k = 0; k < at(contact.point_count); ++k)
        moment += contact.points[k].normal_impulse * (contact.points[k].p_W - center).cross(contact.n_W);
      return moment;
    };
    add_to_row(impulse / step, contact.body_B, loads.force);
    add_to_row(-impulse / step, contact.body_A, loads.force);
    add_to_row(moment_about(contact.body_B) / step, contact.body_B, loads.torque);
    add_to_row(-moment_about(contact.body_A) / step, contact.body_A, loads.torque);
  }
  return loads;
}

}  // namespace rigor
