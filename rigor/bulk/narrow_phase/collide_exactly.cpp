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

/// Takes those points away that are farther than half of the way from the nearest to the margin.
std::vector<ManifoldCandidate> take_far(float margin, std::vector<ManifoldCandidate>& candidates) {
  float nearest = margin;
  for (const ManifoldCandidate& candidate : candidates) nearest = std::min(nearest, candidate.gap);
  const float limit = 0.5f * (nearest + margin);
  const auto first_far =
      std::stable_partition(candidates.begin(), candidates.end(),
                            [&](const ManifoldCandidate& candidate) { return candidate.gap <= limit; });
  std::vector<ManifoldCandidate> far(first_far, candidates.end());
  candidates.erase(first_far, candidates.end());
  return far;
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): two shapes, each with its pose.
void add_exact_manifolds(const Shape& a, const Pose& X_OA, const Shape& b, const Pose& X_OB, float tolerance,
                         float margin, int pair, ManifoldList& manifolds) {
  std::vector<NormalGroup> groups;
  const std::vector<ContactPoint> contacts =
      contact_set(a, X_OA, b, X_OB,
                  ContactReach{std::min(static_cast<double>(tolerance), static_cast<double>(margin)),
                               static_cast<double>(margin)});
  for (const ContactPoint& contact : contacts) add_contact(contact, group_of(contact.n_W, groups));
  int first = 0;
  for (NormalGroup& group : groups) {
    // At most four of the points, which are no candidates any more. A part keeps its number where another of
    // its normal comes or goes.
    const auto push = [&](int part, std::vector<ManifoldCandidate>& candidates) {
      const Manifold manifold = make_manifold(group.n.cast<float>(), 0, candidates);
      manifolds.push_back({pair, part, manifold});
      std::erase_if(candidates, [&](const ManifoldCandidate& candidate) {
        const auto begin = std::begin(manifold.points);
        return std::any_of(begin, begin + manifold.point_count,
                           [&](const ManifoldPoint& point) { return point.feature == candidate.feature; });
      });
    };
    // Eight that are near, since of a solid with many corners any may be the next that touches, and four of
    // the others.
    std::vector<ManifoldCandidate> far;
    if (group.candidates.size() > Manifold::max_points) far = take_far(margin, group.candidates);
    push(first, group.candidates);
    if (!group.candidates.empty()) push(first + 1, group.candidates);
    if (!far.empty()) push(first + 2, far);
    first += 3;
  }
}

}  // namespace rigor
