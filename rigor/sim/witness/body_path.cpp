#include "rigor/sim/witness/body_path.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

PathPiece::PathPiece(double begin, double end, const Motion& motion)
    : begin_(begin), end_(end), angular_speed_(motion.max_angular_speed()), way_(motion) {}

PathPiece::PathPiece(double begin, double end, const StraightWay& way)
    : begin_(begin),
      end_(end),
      angular_speed_(end > begin ? way.turn_W.norm() / (end - begin) : 0),
      way_(way) {}

Pose PathPiece::pose(double t) const {
  if (const Motion* motion = std::get_if<Motion>(&way_)) return motion->sample(t).X_WB;
  const StraightWay& way = std::get<StraightWay>(way_);
  if (way.turn_W.isZero(0)) return {rotation_matrix(way.q), position(t)};
  const double theta = end_ > begin_ ? (t - begin_) / (end_ - begin_) : 0;
  return {rotation_matrix(rotation_exp(theta * way.turn_W) * way.q), position(t)};
}

Vec3 PathPiece::position(double t) const {
  if (const Motion* motion = std::get_if<Motion>(&way_)) return motion->position(t);
  const StraightWay& way = std::get<StraightWay>(way_);
  const double theta = end_ > begin_ ? (t - begin_) / (end_ - begin_) : 0;
  return way.from + theta * (way.to - way.from);
}

bool PathPiece::knows_orientation() const {
  constexpr double little = 1;  // What tumbles by less is near the shortest way [rad].
  const StraightWay* way = std::get_if<StraightWay>(&way_);
  return way == nullptr || way->keeps_axis || way->turn_W.norm() <= little;
}

Aabb PathPiece::centre_box(double ta, double tb) const {
  if (const Motion* motion = std::get_if<Motion>(&way_)) return motion->path_box(ta, tb);
  const StraightWay& way = std::get<StraightWay>(way_);
  const double span = end_ > begin_ ? end_ - begin_ : 1;
  const Vec3 a = way.from + (ta - begin_) / span * (way.to - way.from);
  const Vec3 b = way.from + (tb - begin_) / span * (way.to - way.from);
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

StraightWay straight_way(const Vec3& from, const Quat& q_from, const Vec3& to, const Quat& q_to,
                         const Vec3& w_from, const Vec3& w_to, double h) {
  // The rotation that is left over after whole turns, and the number of turns nearest to what the angular
  // velocities say.
  const Vec3 shortest = rotation_log((q_to * q_from.conjugate()).normalized());
  const Vec3 expected = 0.5 * h * (w_from + w_to);
  const double angle = shortest.norm(), full = 2 * std::numbers::pi;
  Vec3 turn = shortest;
  if (angle > 0) {
    const Vec3 axis = shortest / angle;
    turn = axis * (angle + full * std::round((axis.dot(expected) - angle) / full));
  }
  return {from, to, q_from, turn};
}

}  // namespace rigor
