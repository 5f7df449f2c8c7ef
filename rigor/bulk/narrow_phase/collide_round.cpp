#include "rigor/bulk/narrow_phase/collide_round.hpp"

#include "rigor/bulk/narrow_phase/collide_polytopes.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

/// The axis of a sphere or capsule: from one end to the other.
struct CoreSegment {
  Vec3f p, u;
};

CoreSegment core_segment(const PlacedRound& round, const Vec3f& p_OB) {
  const Vec3f axis(round.placed.R[2], round.placed.R[5], round.placed.R[8]);
  const Vec3f half = round.shape.extent * axis;
  return {p_OB + round.placed.position() - half, 2 * half};
}

/// A unit vector across both segments, or across the one that has a length.
Vec3f across(const Vec3f& u, const Vec3f& v) {
  Vec3f w = u.cross(v);
  if (w.squaredNorm() > 0) return w.normalized();
  const Vec3f& longer = u.squaredNorm() >= v.squaredNorm() ? u : v;
  if (longer.squaredNorm() == 0) return Vec3f::UnitZ();
  int least;
  longer.cwiseAbs().minCoeff(&least);
  return longer.cross(Vec3f::Unit(least)).normalized();
}

/// Ends of the stretch where the segments run side by side, as parameters of the first; false if they do not.
bool find_side_by_side(const CoreSegment& a, const CoreSegment& b, std::array<float, 2>& s) {
  constexpr float square_sine = 1e-6f;  // A milliradian.
  const float uu = a.u.squaredNorm(), vv = b.u.squaredNorm();
  if (uu == 0 || vv == 0 || a.u.cross(b.u).squaredNorm() > square_sine * uu * vv) return false;
  float begin = a.u.dot(b.p - a.p) / uu, end = a.u.dot(b.p + b.u - a.p) / uu;
  if (begin > end) std::swap(begin, end);
  s = {std::max(0.0f, begin), std::min(1.0f, end)};
  return s[0] < s[1];
}

}  // namespace

std::optional<Vec3f> find_round_candidates(const PlacedRound& round_A, const PlacedRound& round_B,
                                           const Vec3f& p_OB, float margin,
                                           std::vector<ManifoldCandidate>& candidates) {
  const BulkShape &a = round_A.shape, &b = round_B.shape;
  const CoreSegment core_A = core_segment(round_A, Vec3f::Zero());
  const CoreSegment core_B = core_segment(round_B, p_OB);
  // The nearest points of the two axes; across both where they meet and no direction is left.
  const SegmentPoints nearest = nearest_on_segments(core_A.p, core_A.u, core_B.p, core_B.u);
  const Vec3f between = core_B.p + nearest.t * core_B.u - core_A.p - nearest.s * core_A.u;
  const float distance = between.norm();
  if (!(distance - a.radius - b.radius <= margin)) return std::nullopt;
  const float rounding = 1e-6f * (a.extent + b.extent + p_OB.norm());
  const Vec3f n = distance > rounding ? Vec3f(between / distance) : across(core_A.u, core_B.u);
  const auto add = [&](float s, float t, std::uint32_t feature) {
    const Vec3f p_A = core_A.p + s * core_A.u, p_B = core_B.p + t * core_B.u;
    const float gap = n.dot(p_B - p_A) - a.radius - b.radius;
    if (gap <= margin)
      candidates.push_back({0.5f * (p_A + p_B) + 0.5f * (a.radius - b.radius) * n, gap, feature});
  };
  // One point, or two at the ends of the stretch where capsules lie side by side: one point would let them
  // rock.
  std::array<float, 2> ends;
  if (!find_side_by_side(core_A, core_B, ends)) {
    add(nearest.s, nearest.t, 0);
    return n;
  }
  for (std::uint32_t k = 0; k < 2; ++k) {
    const float s = ends[k];
    const float t = core_B.u.dot(core_A.p + s * core_A.u - core_B.p) / core_B.u.squaredNorm();
    add(s, std::clamp(t, 0.0f, 1.0f), k);
  }
  return n;
}

PlaneView view_plane(const HalfSpace& plane, const Pose& X_WS, const Vec3& p_WB) {
  const Vec3 n = X_WS.R * plane.normal;
  return {n.cast<float>(), static_cast<float>(n.dot(p_WB - X_WS.p) - plane.offset)};
}

void find_plane_candidates(const PlaneView& plane, const BulkShape& shape, const PlacedShape& placed,
                           float margin, std::vector<ManifoldCandidate>& candidates) {
  const FloatHull& hull = *shape.hull;
  const Mat3f R = placed.rotation();
  const Vec3f center = placed.position();
  for (int v = 0; v < hull.vertex_count; ++v) {
    const std::size_t k = at(v);
    const Vec3f p = R * shape.scale.cwiseProduct(Vec3f(hull.x[k], hull.y[k], hull.z[k])) + center;
    const float gap = plane.n.dot(p) + plane.height - shape.radius;
    if (gap > margin) continue;
    candidates.push_back({p - (0.5f * gap + shape.radius) * plane.n, gap, static_cast<std::uint32_t>(v)});
  }
}

}  // namespace rigor
