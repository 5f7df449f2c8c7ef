#include "rigor/sim/witness/relative_trajectory.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/rays/ray_cast.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

constexpr double largest_turn = 0.5;         // Of a chord [rad].
constexpr double share_of_clearance = 0.25;  // How far a chord may be from the way.
constexpr int most_halvings = 24;

/// Whether a ray that hits there goes from outside into the solid; an open surface has no outside.
bool goes_in(const Shape& shape, const RayHit& hit) {
  const Mesh* mesh = std::get_if<Mesh>(&shape);
  return hit.enters || (mesh != nullptr && !mesh->tree->is_closed);
}

}  // namespace

std::optional<double> RelativeTrajectory::first_entry(double ta, double tb) const {
  const double sway = of_marker_.knows_orientation() ? 0 : offset_;
  if (!of_solid_.knows_orientation() || sway > share_of_clearance * marker_.clearance) return std::nullopt;
  if (stay_apart(ta, tb)) return std::nullopt;
  return between(ta, seen(ta), tb, seen(tb), 0);
}

/// Whether two bodies that go straight come no nearer to each other than the marker and the solid reach: most
/// of those that fall side by side.
bool RelativeTrajectory::stay_apart(double ta, double tb) const {
  if (!of_marker_.is_straight() || !of_solid_.is_straight()) return false;
  const Vec3 begin = of_marker_.position(ta) - of_solid_.position(ta);
  const Vec3 path = of_marker_.position(tb) - of_solid_.position(tb) - begin;
  const double square = path.squaredNorm();
  const double nearest = square > 0 ? std::clamp(-begin.dot(path) / square, 0.0, 1.0) : 0;
  return (begin + nearest * path).norm() > solid_.bounding_radius + offset_;
}

/// The marker in the frame of the other body.
Vec3 RelativeTrajectory::seen(double t) const {
  const Vec3 p_W = offset_ > 0 ? Vec3(of_marker_.pose(t) * marker_.p_B) : of_marker_.position(t);
  return of_solid_.pose(t).inverse() * p_W;
}

/// Whether the boxes of the marker's way and of the solid's meet.
bool RelativeTrajectory::may_meet(double ta, double tb) const {
  if (std::isinf(solid_.bounding_radius)) return true;
  Aabb path = of_marker_.centre_box(ta, tb);
  if (offset_ > 0) {
    // The arm of the marker at ta, which turns by no more than a diameter.
    const Vec3 arm_W = of_marker_.pose(ta).R * marker_.p_B;
    const double sway = offset_ * std::min(2.0, of_marker_.angular_speed() * (tb - ta));
    path = Aabb{path.lower + arm_W, path.upper + arm_W}.grown(sway);
  }
  return path.overlaps(of_solid_.centre_box(ta, tb).grown(solid_.bounding_radius));
}

/// Between two instants at which the marker is seen at a and b: by one chord where the way is straight
/// enough, else in halves.
std::optional<double> RelativeTrajectory::between(double ta, const Vec3& a, double tb, const Vec3& b,
                                                  int halvings) const {
  if (!may_meet(ta, tb)) return std::nullopt;
  const double tm = 0.5 * (ta + tb);
  const Vec3 m = seen(tm);
  // A motion beyond all numbers has no way to follow: the scheme that made it ends as not finite.
  if (!std::isfinite((m - a).stableNorm() + (b - m).stableNorm())) return std::nullopt;
  const double rotation =
      (tb - ta) * std::max(of_solid_.angular_speed(), offset_ > 0 ? of_marker_.angular_speed() : 0.0);
  const bool is_straight =
      rotation <= largest_turn && (m - 0.5 * (a + b)).norm() <= share_of_clearance * marker_.clearance;
  if (!is_straight && halvings < most_halvings) {
    constexpr int many_chords = 8;
    if (halvings == many_chords) poll_interrupt();
    if (const auto early = between(ta, a, tm, m, halvings + 1)) return early;
    return between(tm, m, tb, b, halvings + 1);
  }
  const std::optional<double> share = a == b ? std::nullopt : entry_of_chord(a, b);
  return share ? std::optional(ta + *share * (tb - ta)) : std::nullopt;
}

/// The part of a chord after which it first goes into the solid. A motion beyond all numbers has no chord:
/// the scheme that made it ends as not finite.
std::optional<double> RelativeTrajectory::entry_of_chord(const Vec3& a, const Vec3& b) const {
  for (const RayHit& hit : find_ray_hits(shape_.shape, shape_.X_BS, {a, b - a, 1})) {
    if (goes_in(shape_.shape, hit)) return hit.fraction;
  }
  return std::nullopt;
}

}  // namespace rigor
