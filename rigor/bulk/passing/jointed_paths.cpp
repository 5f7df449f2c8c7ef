#include "rigor/bulk/passing/jointed_paths.hpp"

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>

namespace rigor {

void JointedPaths::begin(std::size_t bodies, int substeps) {
  substeps_ = substeps;
  noted_ = 0;
  jointed_ = 0;
  first_.assign(bodies, -1);
  legs_.clear();
}

void JointedPaths::note(const BulkBodies& bodies, const std::vector<int>& moving,
                        const std::vector<char>& is_jointed) {
  // The first substep decides who is noted: those that move are the same all through the step.
  const bool is_first = noted_++ == 0;
  for (const int body : moving) {
    if (is_jointed[at(body)] == 0) continue;
    if (is_first) first_[at(body)] = static_cast<int>(jointed_++);
    const MotionRecord& m = bodies.motion[at(body)];
    legs_.push_back({m.dp[0], m.dp[1], m.dp[2], m.dr[0], m.dr[1], m.dr[2]});
  }
}

BodyDisplacement JointedPaths::point(int body, double t) const {
  // Between the ends of two substeps.
  const double place = t * substeps_;
  const int k = std::clamp(static_cast<int>(place), 0, substeps_ - 1);
  const double part = place - k;
  const Leg &to = leg(body, k), from = k == 0 ? Leg{} : leg(body, k - 1);
  const Vec3 p = vector_of(from.data()), q = vector_of(to.data());
  const Quat first = rotation_exp(vector_of(from.data() + 3)), last = rotation_exp(vector_of(to.data() + 3));
  return {p + part * (q - p), rotation_exp(part * rotation_log(last * first.conjugate())) * first};
}

Aabb JointedPaths::box(int body) const {
  Aabb box{Vec3::Zero(), Vec3::Zero()};
  for (int k = 0; k < substeps_; ++k) {
    const Vec3 dp = vector_of(leg(body, k).data());
    box = {box.lower.cwiseMin(dp), box.upper.cwiseMax(dp)};
  }
  return box;
}

std::array<double, 2> JointedPaths::lengths(int body) const {
  std::array<double, 2> lengths{};
  for (int k = 0; k < substeps_; ++k) {
    const Leg &to = leg(body, k), from = k == 0 ? Leg{} : leg(body, k - 1);
    for (const std::size_t of : {std::size_t{0}, std::size_t{1}})
      lengths[of] += (vector_of(to.data() + 3 * of) - vector_of(from.data() + 3 * of)).norm();
  }
  return lengths;
}

}  // namespace rigor
