#include "rigor/sim/witness/step_moves.hpp"

#include "rigor/core/index.hpp"
#include "rigor/sim/witness/step_path.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

StepMoves::StepMoves(const Model& model, const Environment& environment,
                     const std::vector<std::shared_ptr<const MarkedBody>>& marked)
    : model_(&model), moves_(marked.size()) {
  for (int i = 0; i < model.body_count(); ++i) {
    const Body& body = model.body(i);
    const bool is_dynamic = body.motion == MotionType::dynamic;
    bounds_.push_back({body.motion, marked[at(i)]->turning, is_dynamic ? body.moments.minCoeff() : 0,
                       is_dynamic ? environment.steady_acceleration(i).norm() : 0});
  }
}

const std::vector<StepMove>& StepMoves::between(const State& before, const State& after) {
  for (int i = 0; i < model_->body_count(); ++i) {
    if (bounds_[at(i)].motion == MotionType::fixed) continue;
    moves_[at(i)] = move(i, before, after);
  }
  return moves_;
}

StepMove StepMoves::move(int i, const State& before, const State& after) const {
  const Bounds& body = bounds_[at(i)];
  const Vec3 d = after.position(i) - before.position(i);
  const Vec4 q = Vec4::Map(&before.q[4 * at(i)]), r = Vec4::Map(&after.q[4 * at(i)]);
  const double chord = std::sqrt(std::min((q - r).squaredNorm(), (q + r).squaredNorm()));
  if (chord <= 1 && !may_spin(i, before, after)) {
    // The rotation between two quaternions is by 4 asin(|q - r|/2), which is at most 2.1 |q - r| there.
    return {d, chord > 0 ? 2.1 * chord * body.turning : 0, 0};
  }
  // Whatever it turns by, no point leaves its sphere about the centre, which may go along an arc.
  const double h = after.t - before.t;
  const double arc = 0.125 * h * h * body.acceleration;
  return {d, 2 * body.turning + arc, arc};
}

/// Whether the body may have turned by other than the shortest rotation, or flown along an arc (step_path).
bool StepMoves::may_spin(int i, const State& before, const State& after) const {
  constexpr double little = 0.5;  // [rad].
  const Bounds& body = bounds_[at(i)];
  if (body.motion != MotionType::dynamic) return !(step_turn(*model_, i, before, after) <= little);
  // |ω| ≤ |L| / I, with the smallest moment.
  const double h = after.t - before.t, most = little * body.least_moment / h;
  const double L_squared =
      std::max(before.angular_momentum(i).squaredNorm(), after.angular_momentum(i).squaredNorm());
  return !(L_squared <= most * most);
}

}  // namespace rigor
