#pragma once

#include "rigor/dynamics/environment.hpp"
#include "rigor/model/model.hpp"
#include "rigor/model/state.hpp"
#include "rigor/sim/witness/marked_body.hpp"

#include <memory>
#include <span>
#include <vector>

namespace rigor {

/// How a body moves within a step, along any way that step_path() may give it: at the share s of the step the
/// markers and enclosures of the body are where s d takes them, up to `turn` [m].
struct StepMove {
  Vec3 d = Vec3::Zero();  ///< Displacement of the centre of mass [m].
  double turn = 0;        ///< [m]; infinite if nothing is known.
  double arc = 0;         ///< The part of it by which the centre may leave the straight way [m].
};

/// Makes the moves of all bodies, from little of each: they are asked for at each step.
class StepMoves {
 public:
  StepMoves(const Model& model, const Environment& environment,
            const std::vector<std::shared_ptr<const MarkedBody>>& marked);

  const std::vector<StepMove>& between(const State& before, const State& after);

 private:
  /// What it takes to bound the turn of a body.
  struct Bounds {
    MotionType motion;
    double turning;       ///< MarkedBody::turning [m].
    double least_moment;  ///< Smallest moment of inertia of a dynamic body [kg m²].
    double acceleration;  ///< In flight [m/s²].
  };
  StepMove move(int body, const State& before, const State& after) const;
  bool may_spin(int body, const State& before, const State& after) const;

  const Model* model_;
  std::vector<Bounds> bounds_;
  std::vector<StepMove> moves_;
};

}  // namespace rigor
