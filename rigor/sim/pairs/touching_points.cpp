#include "rigor/sim/pairs/touching_points.hpp"

#include "rigor/sim/pairs/near_pairs.hpp"
#include "rigor/solver/coulomb/coulomb_problem.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

Vec3 velocity_of_point(const Model& model, const State& state, int body, const Vec3& p_W) {
  return linear_velocity(model, state, body) +
         angular_velocity(model, state, body).cross(p_W - state.position(body));
}

bool comes_before(const ContactKey& a, const ContactKey& b) {
  return std::pair(a.body_A, a.body_B) < std::pair(b.body_A, b.body_B);
}

/// The one of these contacts of a pair that has the force: the same, or the nearest.
std::size_t place_of_force(const ContactForce& force, const std::vector<Contact>& contacts, std::size_t begin,
                           std::size_t end) {
  std::size_t nearest = begin;
  for (std::size_t i = begin; i < end; ++i) {
    if (contacts[i].key() == force.key) return i;
    const auto distance = [&](std::size_t k) { return (contacts[k].p_W() - force.p_W).squaredNorm(); };
    if (distance(i) < distance(nearest)) nearest = i;
  }
  return nearest;
}

}  // namespace

TouchingPoint::Mode mode_of(ContactMode mode) {
  switch (mode) {
    case ContactMode::open:
      return TouchingPoint::Mode::open;
    case ContactMode::stick:
      return TouchingPoint::Mode::stick;
    case ContactMode::slide:
      return TouchingPoint::Mode::slide;
  }
  return TouchingPoint::Mode::unknown;
}

std::vector<Contact> touching_contacts(const Model& model, const State& state, double tolerance) {
  std::vector<Contact> contacts;
  for (const auto& [a, b] : near_pairs(model, state, tolerance)) {
    if (model.body(a).motion != MotionType::dynamic && model.body(b).motion != MotionType::dynamic) continue;
    const std::vector<Contact> found =
        find_contacts(model, a, b, pose_of(state, a), pose_of(state, b), tolerance);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

std::vector<TouchingPoint> touching_points(const Model& model, const State& state,
                                           std::vector<Contact> contacts,
                                           const std::vector<ContactForce>& forces) {
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return comes_before(a.key(), b.key()); });

  // Where bodies touch, and how the points move.
  std::vector<TouchingPoint> points;
  points.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    const Vec3 p_W = contact.p_W();
    points.push_back({.body_A = contact.body_A,
                      .body_B = contact.body_B,
                      .p_W = p_W,
                      .n_W = contact.point.n_W,
                      .gap = contact.point.gap,
                      .u_W = velocity_of_point(model, state, contact.body_B, p_W) -
                             velocity_of_point(model, state, contact.body_A, p_W)});
  }

  // Each force goes to its point: pairs are in order.
  for (const ContactForce& force : forces) {
    const auto first = std::lower_bound(
        contacts.begin(), contacts.end(), force.key,
        [](const Contact& contact, const ContactKey& key) { return comes_before(contact.key(), key); });
    const auto last = std::upper_bound(
        first, contacts.end(), force.key,
        [](const ContactKey& key, const Contact& contact) { return comes_before(key, contact.key()); });
    if (first == last) continue;
    const std::size_t begin = static_cast<std::size_t>(first - contacts.begin());
    const std::size_t end = static_cast<std::size_t>(last - contacts.begin());
    TouchingPoint& point = points[place_of_force(force, contacts, begin, end)];
    point.force_W += force.force_W;
    if (point.mode != TouchingPoint::Mode::unknown) point.mode = force.mode;
  }
  return points;
}

}  // namespace rigor
