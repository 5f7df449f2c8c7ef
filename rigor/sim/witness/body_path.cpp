#include "rigor/sim/witness/body_path.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

PathPiece::PathPiece(double begin, double end, const Motion& motion)
    : begin_(begin), end_(end), angular_speed_(motion.max_angular_speed()), path_(motion) {}

PathPiece::PathPiece(double begin, double end, const StraightPath& path)
    : begin_(begin),
      end_(end),
      angular_speed_(end > begin ? path.rotation_W.norm() / (end - begin) : 0),
      path_(path) {}

Pose PathPiece::pose(double t) const {
  if (const Motion* motion = std::get_if<Motion>(&path_)) return motion->sample(t).X_WB;
  const StraightPath& path = std::get<StraightPath>(path_);
  if (path.rotation_W.isZero(0)) return {rotation_matrix(path.q), position(t)};
  const double theta = end_ > begin_ ? (t - begin_) / (end_ - begin_) : 0;
  return {rotation_matrix(rotation_exp(theta * path.rotation_W) * path.q), position(t)};
}

Vec3 PathPiece::position(double t) const {
  if (const Motion* motion = std::get_if<Motion>(&path_)) return motion->position(t);
  const StraightPath& path = std::get<StraightPath>(path_);
  const double theta = end_ > begin_ ? (t - begin_) / (end_ - begin_) : 0;
  return path.from + theta * (path.to - path.from);
}

bool PathPiece::knows_orientation() const {
  constexpr double little = 1;  // What tumbles by less is near the shortest way [rad].
  const StraightPath* path = std::get_if<StraightPath>(&path_);
  return path == nullptr || path->keeps_axis || path->rotation_W.norm() <= little;
}

Aabb PathPiece::centre_box(double ta, double tb) const {
  if (const Motion* motion = std::get_if<Motion>(&path_)) return motion->path_box(ta, tb);
  const StraightPath& path = std::get<StraightPath>(path_);
  const double span = end_ > begin_ ? end_ - begin_ : 1;
  const Vec3 a = path.from + (ta - begin_) / span * (path.to - path.from);
  const Vec3 b = path.from + (tb - begin_) / span * (path.to - path.from);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

StraightPath straight_path(const PathEnd& from, const PathEnd& to, double h) {
  // The rotation that is left over after whole turns, and the number of turns nearest to what the angular
  // velocities say.
  const Vec3 shortest = rotation_log((to.q * from.q.conjugate()).normalized());
  const Vec3 expected = 0.5 * h * (from.w + to.w);
  const double angle = shortest.norm(), full = 2 * std::numbers::pi;
  Vec3 rotation = shortest;
  if (angle > 0) {
    const Vec3 axis = shortest / angle;
    rotation = axis * (angle + full * std::round((axis.dot(expected) - angle) / full));
  }
  return {from.x, to.x, from.q, rotation};
}

}  // namespace rigor
