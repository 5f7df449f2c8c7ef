#include "rigor/bulk/slender_towers.hpp"

#include "rigor/bulk/manifold_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace rigor {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

float pressure(const ManifoldMemory& memory) {
  float sum = 0;
  for (const float impulse : memory.normal_impulse) sum += impulse;
  return sum;
}

/// Whether the body is the first of two pairs with other dynamic bodies: then it is no tower's. Pairs are in
/// the order of their first bodies.
bool meets_two(const std::vector<ManifoldMemory>& memory, const std::vector<std::uint8_t>& is_dynamic,
               int body) {
  const auto before = [](const ManifoldMemory& m, int first) { return m.body_A < first; };
  int other = -1;
  for (auto m = std::lower_bound(memory.begin(), memory.end(), body, before);
       m != memory.end() && m->body_A == body; ++m) {
    if (is_dynamic[at(m->body_B)] == 0 || m->body_B == other) continue;
    if (other >= 0) return true;
    other = m->body_B;
  }
  return false;
}

}  // namespace

SlenderTowers::SlenderTowers(const Model& model) : gravity_(model.g_W().norm()) {
  for (const Body& body : model.bodies()) {
    is_dynamic_.push_back(body.motion == MotionType::dynamic ? 1 : 0);
    weight_.push_back(static_cast<float>(body.mass * gravity_));
    size_.push_back(static_cast<float>(body.bounding_radius));
  }
}

bool SlenderTowers::are_there(const std::vector<ManifoldMemory>& memory, double substep) {
  carries_.clear();
  if (!(gravity_ > 0)) return false;
  const double omega = 2 * std::numbers::pi * contact_frequency_a_substep / substep;
  const float cube = static_cast<float>(omega * omega / gravity_);  // Of the number that buckles, by size.
  const float h = static_cast<float>(substep);
  for (const ManifoldMemory& m : memory) {
    if (is_dynamic_[at(m.body_A)] == is_dynamic_[at(m.body_B)]) continue;
    const int body = is_dynamic_[at(m.body_A)] != 0 ? m.body_A : m.body_B;
    const float number = pressure(m) / (h * weight_[at(body)]);
    if (27 * number * number * number < 8 * cube * size_[at(body)]) continue;
    if (meets_two(memory, is_dynamic_, body)) continue;
    carries_.resize(is_dynamic_.size(), false);
    carries_[at(body)] = true;
  }
  return !carries_.empty();
}

}  // namespace rigor
