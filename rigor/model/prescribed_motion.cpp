#include "rigor/core/time_rounding.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/state.hpp"

#include <algorithm>

namespace rigor {

namespace {

PrescribedMotion at_rest(const PathPoint& point) {
  return {point.p_WU, point.q_WU, Vec3::Zero(), Vec3::Zero()};
}

/// On the leg from a to b: positions on the line, rotation about one fixed axis of W.
PrescribedMotion along_leg(const PathPoint& a, const PathPoint& b, double t) {
  const double duration = b.time - a.time;
  const double s = (t - a.time) / duration;
  const Vec3 rotation_W = rotation_log(b.q_WU * a.q_WU.conjugate());
  return {a.p_WU + s * (b.p_WU - a.p_WU), rotation_exp(s * rotation_W) * a.q_WU, (b.p_WU - a.p_WU) / duration,
          rotation_W / duration};
}

}  // namespace

PrescribedMotion prescribed_motion(const Body& body, double t) {
  if (body.motion == MotionType::fixed) return {body.p_WB, body.q_WB, Vec3::Zero(), Vec3::Zero()};
  if (body.path.empty()) {
    return {body.p_WB + t * body.v_WB, rotation_exp(t * body.w_WB) * body.q_WB, body.v_WB, body.w_WB};
  }
  const std::vector<PathPoint>& path = body.path;
  // Where a leg ends within the rounding of t the next one has begun.
  const double now = t + time_rounding_at(t);
  if (now < path.front().time) return at_rest(path.front());
  if (now >= path.back().time) return at_rest(path.back());
  const auto is_later = [](double time, const PathPoint& point) { return time < point.time; };
  const auto next = std::upper_bound(path.begin(), path.end(), now, is_later);
  return along_leg(*(next - 1), *next, t);
}

}  // namespace rigor
