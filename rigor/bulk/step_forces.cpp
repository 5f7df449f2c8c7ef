#include "rigor/bulk/step_forces.hpp"

#include "rigor/bulk/state/drag.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace rigor {

namespace {

bool is_damped(const Body& body) {
  return body.linear_drag != 0 || body.angular_drag != 0 || body.linear_damping != 0 ||
         body.angular_damping != 0;
}

}  // namespace

StepForces::StepForces(const Model& model)
    : model_(model), environment_(environment_of(model)), springs_(model) {}

Environment StepForces::environment_of(const Model& model) {
  return Environment(model, PointSprings::left_out, false);
}

void StepForces::change(const ChangedBodies& changed) {
  // Gravity is read from the Model; the environment knows the bodies on which more acts.
  const auto acts_more = [&](int body) {
    return is_damped(model_.body(body)) || environment_.has_drag(body) || environment_.is_forced(body);
  };
  if (changed.are_ties_new || std::any_of(changed.bodies.begin(), changed.bodies.end(), acts_more))
    environment_ = environment_of(model_);
  if (changed.are_ties_new) springs_ = BulkSprings(model_);
}

void StepForces::compute(const BulkBodies& bodies, double h, int substeps, const Executor& executor) {
  accelerations_.resize(bodies.x.size());
  const auto view = [&](int body) {
    const std::size_t k = at(body);
    const MotionRecord& m = bodies.motion[k];
    return Environment::BodyView{bodies.x[k], vector_of(m.v), vector_of(m.w), bodies.q[k].toRotationMatrix(),
                                 bodies.is_dynamic(body)};
  };
  executor.for_ranges(bodies.count(), 256, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      MotionRow& row = accelerations_[at(i)];
      row = {};
      if (!bodies.is_dynamic(i)) continue;
      // Gravity and constant forces are known once for all; other forces are those of now, and drag is
      // integrated over the step, so that none is too strong for it.
      Vec3 a = environment_.steady_acceleration(i), alpha = Vec3::Zero();
      if (environment_.is_forced(i)) {
        Wrench wrench;
        environment_.apply_env_forces(std::span(&i, 1), view, std::span(&wrench, 1));
        const MeanAcceleration mean =
            mean_acceleration(model_.body(i), environment_.drag(i), view(i).R, wrench, h);
        a = mean.a;
        alpha = mean.alpha;
      }
      for (int k = 0; k < 3; ++k) {
        row[at(k)] = static_cast<float>(a[k]);
        row[at(4 + k)] = static_cast<float>(alpha[k]);
      }
    }
  });
  add_given(bodies);
  springs_.add(bodies, h, substeps, accelerations_);
}

void StepForces::add_given(const BulkBodies& bodies) {
  for (const GivenWrench& given : given_) {
    const Body& body = model_.body(given.body);
    const Quat& q_WB = bodies.q[at(given.body)];
    const Vec3 a = given.wrench.f_W / body.mass;
    // α = I⁻¹ τ along the principal axes.
    const Vec3 alpha = q_WB * (q_WB.conjugate() * given.wrench.tau_W).cwiseQuotient(body.moments);
    MotionRow& row = accelerations_[at(given.body)];
    for (int k = 0; k < 3; ++k) {
      row[at(k)] += static_cast<float>(a[k]);
      row[at(4 + k)] += static_cast<float>(alpha[k]);
    }
  }
}

double StepForces::work(const BulkBodies& bodies) const {
  double work = 0;
  // Wrenches that the user gave are constant in the step.
  for (const GivenWrench& given : given_) {
    const MotionRecord& m = bodies.motion[at(given.body)];
    work += given.wrench.f_W.dot(vector_of(m.dp)) + given.wrench.tau_W.dot(vector_of(m.dr));
  }
  // Forces of the environment are those of the beginning of the step too.
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i) || !environment_.is_forced(i)) continue;
    const std::size_t k = at(i);
    const MotionRecord& m = bodies.motion[k];
    work += environment_.supplied_power(
        i, {bodies.x[k], vector_of(m.dp), vector_of(m.dr), bodies.q[k].toRotationMatrix(), true});
  }
  return work;
}

}  // namespace rigor
