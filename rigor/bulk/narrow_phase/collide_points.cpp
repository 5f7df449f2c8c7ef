#include "rigor/bulk/narrow_phase/collide_points.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

/// A later candidate must be better by this factor.
constexpr float kClearly = 1.0001f;

/// Index of the candidate with the largest positive measure, the first of those that are equally good; -1 if
/// no measure is positive.
template <typename Measure>
int find_largest(const std::vector<ManifoldCandidate>& candidates, const Measure& measure) {
  int best = -1;
  float largest = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const float value = measure(candidates[k].p);
    if (value <= kClearly * largest) continue;
    largest = value;
    best = static_cast<int>(k);
  }
  return best;
}

int find_deepest(const std::vector<ManifoldCandidate>& candidates, float equal_depth) {
  float least = candidates[0].gap;
  for (const ManifoldCandidate& candidate : candidates) least = std::min(least, candidate.gap);
  int k = 0;
  while (candidates[at(k)].gap > least + equal_depth) ++k;
  return k;
}

/// Up to four indices, ascending; -1 stands for none.
std::array<int, 4> choose_four(const Vec3f& normal, float equal_depth,
                               const std::vector<ManifoldCandidate>& candidates) {
  const auto point = [&](int k) -> const Vec3f& { return candidates[at(k)].p; };
  std::array<int, 4> chosen = {find_deepest(candidates, equal_depth), -1, -1, -1};
  const Vec3f& p0 = point(chosen[0]);
  // The one farthest from the deepest.
  chosen[1] = find_largest(candidates, [&](const Vec3f& p) { return (p - p0).squaredNorm(); });
  if (chosen[1] < 0) return chosen;
  // The one that makes the largest triangle with them; the measure is twice its area, positive to the left.
  const Vec3f& p1 = point(chosen[1]);
  const Vec3f left = normal.cross(p1 - p0);
  chosen[2] = find_largest(candidates, [&](const Vec3f& p) { return std::abs(left.dot(p - p0)); });
  if (chosen[2] >= 0) {
    // The one that adds most to the triangle: the farthest beyond one of its sides.
    const Vec3f& p2 = point(chosen[2]);
    const float turn = left.dot(p2 - p0) > 0 ? 1.0f : -1.0f;
    const Vec3f right_01 = -turn * left;
    const Vec3f right_12 = -turn * normal.cross(p2 - p1), right_20 = -turn * normal.cross(p0 - p2);
    chosen[3] = find_largest(candidates, [&](const Vec3f& p) {
      return std::max({right_01.dot(p - p0), right_12.dot(p - p1), right_20.dot(p - p2)});
    });
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace

Manifold make_manifold(const Vec3f& normal, float equal_depth, std::vector<ManifoldCandidate>& candidates) {
  // Sorted by feature and each feature once: the result does not depend on the order in which candidates were
  // found.
  const auto comes_before = [](const ManifoldCandidate& a, const ManifoldCandidate& b) {
    return a.feature != b.feature ? a.feature < b.feature : a.gap < b.gap;
  };
  const auto is_same = [](const ManifoldCandidate& a, const ManifoldCandidate& b) {
    return a.feature == b.feature;
  };
  candidates = sorted_unique(std::move(candidates), comes_before, is_same);

  Manifold manifold{};
  for (int i = 0; i < 3; ++i) manifold.normal[i] = normal[i];
  const auto add = [&](const ManifoldCandidate& c) {
    ManifoldPoint& point = manifold.points[at(manifold.point_count++)];
    point = {{c.p.x(), c.p.y(), c.p.z()}, c.gap, c.feature};
  };
  // All candidates if there are no more than four, else four of them.
  if (candidates.size() <= Manifold::max_points) {
    for (const ManifoldCandidate& candidate : candidates) add(candidate);
    return manifold;
  }
  for (const int k : choose_four(normal, equal_depth, candidates))
    if (k >= 0) add(candidates[at(k)]);
  return manifold;
}

}  // namespace rigor
