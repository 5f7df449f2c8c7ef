#include "rigor/model/model.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

std::optional<int> Model::find_body(const std::string& name) const {
  const auto name_of = [this](int i) -> const std::string& { return body(i).name; };
  const auto found = std::ranges::lower_bound(by_name_, name, {}, name_of);
  if (found == by_name_.end() || name_of(*found) != name) return std::nullopt;
  return *found;
}

bool Model::has_motor(int i) const {
  const auto drives_it = [i](const JointDrive& drive) { return drive.joint == i; };
  return joint(i).has_motor() || std::ranges::any_of(drives_.joints, drives_it);
}

std::vector<int> Model::bodies_of_joint(int i) const {
  const Joint& own = joint(i);
  std::vector<int> bodies = {own.body_A, own.body_B};
  if (own.type == JointType::gear) {
    const Joint &first = joint(own.first_joint), &second = joint(own.second_joint);
    bodies = {first.body_A, first.body_B, second.body_A, second.body_B};
  }
  std::erase(bodies, world_body);
  return sorted_unique(std::move(bodies));
}

PairCoefficients Model::coefficients(int material_a, int material_b) const {
  const auto override_of_pair = pair_overrides_.find(std::minmax(material_a, material_b));
  if (override_of_pair != pair_overrides_.end()) return override_of_pair->second;
  return combined_coefficients(materials_[at(material_a)], materials_[at(material_b)]);
}

bool Model::may_collide(int a, int b) const {
  if (a == b) return false;
  const Body& A = body(a);
  const Body& B = body(b);
  if (A.motion != MotionType::dynamic && B.motion != MotionType::dynamic) return false;
  if (A.shapes.empty() || B.shapes.empty()) return false;
  if ((A.group & B.mask) == 0 || (B.group & A.mask) == 0) return false;
  const std::pair<int, int> pair = std::minmax(a, b);
  return !std::binary_search(excluded_pairs_.begin(), excluded_pairs_.end(), pair);
}

}  // namespace rigor
