#include "rigor/bulk/direct/slender_towers.hpp"

#include "rigor/bulk/matching/manifold_blocks.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

/// The sum of the normal impulses of a manifold [N s].
float pressure(const ManifoldMemories::View& memory) {
  float sum = 0;
  for (int k = 0; k < memory.point_count; ++k) sum += memory.normal_impulse[k];
  return sum;
}

/// Whether the body is the first of two pairs with different dynamic bodies: then it is not the lowest of a
/// tower. Pairs are in the order of their first bodies.
bool meets_two(const ManifoldMemories& memory, const std::vector<std::uint8_t>& is_dynamic, int body) {
  int other = -1;
  for (std::size_t i = memory.find_from({.body_A = body}); i < memory.size() && memory.body_A(i) == body;
       ++i) {
    if (is_dynamic[at(memory.body_B(i))] == 0 || memory.body_B(i) == other) continue;
    if (other >= 0) return true;
    other = memory.body_B(i);
  }
  return false;
}

}  // namespace

SlenderTowers::SlenderTowers(const Model& model)
    : is_dynamic_(model.bodies().size()), weight_(model.bodies().size()), size_(model.bodies().size()) {
  set_gravity(model);
}

void SlenderTowers::set_gravity(const Model& model) {
  gravity_ = model.g_W().norm();
  for (int i = 0; i < model.body_count(); ++i) set_body(model, i);
}

void SlenderTowers::set_body(const Model& model, int body) {
  const Body& own = model.body(body);
  is_dynamic_[at(body)] = own.motion == MotionType::dynamic ? 1 : 0;
  weight_[at(body)] = static_cast<float>(own.mass * gravity_);
  size_[at(body)] = static_cast<float>(own.bounding_radius);
}

bool SlenderTowers::may_be_there(const ManifoldMemories& memory, double substep) {
  least_mass_.clear();
  if (!(gravity_ > 0) || weight_.empty()) return false;

  // Cubes of the side a buckle from (ω² a/g)^(1/3) of them on.
  const double omega = 2 * std::numbers::pi * contact_frequency_a_substep / substep;
  const float cube = static_cast<float>(omega * omega / gravity_);  // Of the number that buckles, by size.
  const float h = static_cast<float>(substep);

  // Where nothing is remembered any body may be the lowest.
  if (memory.empty()) {
    for (std::size_t i = 0; i < size_.size(); ++i) least_mass_.push_back(slender_mass(i, cube));
    return true;
  }

  // Bodies that press on what stands still with the weight of more than two thirds of that number of bodies.
  for (std::size_t i = 0; i < memory.size(); ++i) {
    const int a = memory.body_A(i), b = memory.body_B(i);
    if (is_dynamic_[at(a)] == is_dynamic_[at(b)]) continue;
    const int body = is_dynamic_[at(a)] != 0 ? a : b;
    const float number = pressure(memory.view(i)) / (h * weight_[at(body)]);
    if (27 * number * number * number < 8 * cube * size_[at(body)]) continue;
    if (meets_two(memory, is_dynamic_, body)) continue;
    least_mass_.resize(is_dynamic_.size(), std::numeric_limits<double>::infinity());
    least_mass_[at(body)] = slender_mass(at(body), cube);
  }
  if (!least_mass_.empty()) drop_others(memory, substep);
  return !least_mass_.empty();
}

/// Two thirds of the mass that buckles on this body; cube: of the number of cubes that does, by their size.
double SlenderTowers::slender_mass(std::size_t body, float cube) const {
  return 2.0 / 3 * std::cbrt(static_cast<double>(cube * size_[body])) * static_cast<double>(weight_[body]) /
         gravity_;
}

/// Forgets bodies that touch more than one other dynamic body, and those on which the other one presses with
/// less than half of that weight: they have just hit what stands still.
void SlenderTowers::drop_others(const ManifoldMemories& memory, double substep) {
  struct Load {
    int from = -1;  // The other body.
    bool is_of_one = true;
    float pressure = 0;
  };
  // What presses on each of the bodies from above.
  std::vector<Load> loads(is_dynamic_.size());
  const auto add = [&](int body, int other, float pressed) {
    Load& load = loads[at(body)];
    load.is_of_one = load.is_of_one && (load.from < 0 || load.from == other);
    load.from = other;
    load.pressure += pressed;
  };
  for (std::size_t i = 0; i < memory.size(); ++i) {
    const int a = memory.body_A(i), b = memory.body_B(i);
    if (is_dynamic_[at(a)] == 0 || is_dynamic_[at(b)] == 0) continue;
    if (std::isinf(least_mass_[at(a)]) && std::isinf(least_mass_[at(b)])) continue;
    const float pressed = pressure(memory.view(i));
    add(a, b, pressed);
    add(b, a, pressed);
  }

  // The bodies that remain.
  bool is_any_left = false;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (std::isinf(least_mass_[i])) continue;
    if (!loads[i].is_of_one ||
        2 * static_cast<double>(loads[i].pressure) < least_mass_[i] * gravity_ * substep)
      least_mass_[i] = std::numeric_limits<double>::infinity();
    else
      is_any_left = true;
  }
  if (!is_any_left) least_mass_.clear();
}

}  // namespace rigor
