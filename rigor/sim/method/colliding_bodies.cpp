#include "rigor/sim/method/colliding_bodies.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>

namespace rigor {

namespace {

/// What the collision filters know of a body: group, mask, whether it is dynamic.
using FilterClass = std::tuple<std::uint32_t, std::uint32_t, bool>;

FilterClass filter_class(const Body& body) {
  return {body.group, body.mask, body.motion == MotionType::dynamic};
}

/// Whether any body of the classes passes the filters of this one.
bool has_partner_class(const Body& body, const std::set<FilterClass>& classes) {
  return std::any_of(classes.begin(), classes.end(), [&](const FilterClass& other) {
    const auto& [group, mask, is_dynamic] = other;
    return (body.group & mask) != 0 && (body.mask & group) != 0;
  });
}

}  // namespace

std::vector<int> colliding_bodies(const Model& model) {
  std::set<FilterClass> classes;
  for (const Body& body : model.bodies()) {
    if (!body.shapes.empty()) classes.insert(filter_class(body));
  }
  std::vector<int> colliding;
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    if (body.motion != MotionType::dynamic || body.shapes.empty() || !has_partner_class(body, classes))
      continue;
    for (int k = 0; k < model.body_count(); ++k) {
      if (k == i || !model.may_collide(i, k)) continue;
      colliding.push_back(i);
      break;
    }
  }
  return colliding;
}

}  // namespace rigor
