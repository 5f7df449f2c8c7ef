#include "rigor/bulk/narrow_phase/collide_exactly.hpp"

#include "rigor/bulk/narrow_phase/collide_points.hpp"
#include "rigor/geometry/contacts/contact_set.hpp"

#include <algorithm>

namespace rigor {

namespace {

/// The contacts that share the normal of the first of them.
struct NormalGroup {
  Vec3 n;
  std::vector<ManifoldCandidate> candidates;
};

/// A 32-bit name of a pair of features (Knuth's multiplicative hashing).
std::uint32_t short_feature(std::uint64_t feature) {
  return static_cast<std::uint32_t>((feature * 0x9e3779b97f4a7c15ULL) >> 32);
}

NormalGroup& group_of(const Vec3& n, std::vector<NormalGroup>& groups) {
  constexpr double square_of_angle = 1e-6;
  for (NormalGroup& group : groups)
    if ((group.n - n).squaredNorm() < square_of_angle) return group;
  groups.push_back({n, {}});
  return groups.back();
}

void add_contact(const ContactPoint& contact, NormalGroup& group) {
  const Vec3 middle = 0.5 * (contact.p_WA + contact.p_WB);
  // Two names may share their 32 bits: the later contact takes the next name, so that features differ within
  // a manifold.
  std::uint32_t feature = short_feature(contact.feature);
  const auto is_taken = [&](const ManifoldCandidate& candidate) { return candidate.feature == feature; };
  while (std::any_of(group.candidates.begin(), group.candidates.end(), is_taken)) ++feature;
  group.candidates.push_back({middle.cast<float>(), static_cast<float>(contact.gap), feature});
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two shapes, each with its pose.
void add_exact_manifolds(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB, float margin,
                         int pair, ManifoldList& manifolds) {
  std::vector<NormalGroup> groups;
  const std::vector<ContactPoint> contacts = contact_set(a, X_OA, b, X_OB, margin);
  for (const ContactPoint& contact : contacts) add_contact(contact, group_of(contact.n_W, groups));
  int part = 0;
  for (NormalGroup& group : groups)
    manifolds.push_back({pair, part++, make_manifold(group.n.cast<float>(), 0, group.candidates)});
}

}  // namespace rigor
