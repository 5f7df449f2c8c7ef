#include "rigor/bulk/contacts/energy_bound.hpp"

#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/core/index.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace rigor {

namespace {

/// Gains below this part of the energies of which they are differences are roundings of velocities.
constexpr double rounding = 1e-6;
/// So are gains below that part of this many times the energy that lifts a body by its radius: springs do
/// not know better what they hold while they swing.
constexpr double lift_share = 10;

/// Kinetic energy between two steps, when the momenta are known.
double kinetic_energy(const Model& model, int body, const BulkBodies& bodies) {
  const MotionRecord& motion = bodies.motion[at(body)];
  return 0.5 * (model.body(body).mass * vector_of(motion.v).squaredNorm() +
                vector_of(motion.w).dot(bodies.L[at(body)]));
}

/// What the spring of a manifold has come to hold in the step [J].
double grown_energy(const StepManifolds& manifolds, const ManifoldMemories& memory, std::size_t i) {
  return static_cast<double>(memory.energy(i)) - static_cast<double>(manifolds.energy(i));
}

}  // namespace

EnergyBound::EnergyBound(const Model& model)
    : model_(&model), islands_(model), lift_(at(model.body_count()), 0) {
  set_gravity();
  find_tied();
}

void EnergyBound::set_gravity() {
  for (int i = 0; i < model_->body_count(); ++i) find_lift(i);
}

void EnergyBound::change(const ChangedBodies& changed) {
  for (const int body : changed.bodies) find_lift(body);
  if (changed.are_ties_new) find_tied();
  islands_.change(*model_, changed);
}

/// What is nothing to a body at rest.
void EnergyBound::find_lift(int body) {
  const Body& own = model_->body(body);
  const bool is_lifted = own.motion == MotionType::dynamic;
  lift_[at(body)] = is_lifted ? lift_share * own.mass * model_->g_W().norm() * own.bounding_radius : 0;
}

/// Finds the bodies that joints and springs hold.
void EnergyBound::find_tied() {
  const Model& model = *model_;
  is_unknown_.assign(lift_.size(), 0);
  is_anchored_ = is_jointed_ = is_unknown_;
  const auto mark = [&](int body) {
    if (body != world_body) is_unknown_[at(body)] = 1;
  };
  // A spring of the scene exchanges energy with its bodies that is not counted here.
  for (const Force& force : model.forces()) {
    const Spring* const spring = std::get_if<Spring>(&force);
    if (spring != nullptr) mark(spring->body_A), mark(spring->body_B);
  }
  // Motors, springs along joints and prescribed bodies do work through them; a body that hangs on something
  // fixed passes momentum to it.
  for (int j = 0; j < static_cast<int>(model.joints().size()); ++j) {
    const std::vector<int> bodies = model.bodies_of_joint(j);
    bool is_unknown = false;
    for (const JointAxis& axis : model.joint(j).axes)
      is_unknown = is_unknown || axis.motor.has_value() || axis.stiffness > 0;
    bool is_anchored = model.joint(j).body_A == world_body || model.joint(j).body_B == world_body;
    for (const int body : bodies) {
      is_jointed_[at(body)] = 1;
      is_unknown = is_unknown || model.body(body).motion == MotionType::kinematic;
      is_anchored = is_anchored || model.body(body).motion != MotionType::dynamic;
    }
    // All bodies of a joint have what holds for one of them.
    if (is_anchored) {
      for (const int body : bodies) is_anchored_[at(body)] = 1;
    }
    if (is_unknown) std::for_each(bodies.begin(), bodies.end(), mark);
  }
}

void EnergyBound::begin(const BulkBodies& bodies, const Executor& executor) {
  begin_.resize(bodies.x.size());
  work_.assign(bodies.x.size(), 0);
  executor.for_ranges(bodies.count(), 1024, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      begin_[at(i)] = bodies.is_dynamic(i) ? kinetic_energy(*model_, i, bodies) : 0;
  });
}

void EnergyBound::add_work(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations,
                           const Executor& executor) {
  executor.for_ranges(bodies.count(), 1024, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (!bodies.is_dynamic(i)) continue;
      const Body& body = model_->body(i);
      const MotionRecord& moved = bodies.motion[at(i)];
      const MotionRow& row = accelerations[at(i)];
      // The work of a constant acceleration is its force times the displacement of the centre.
      work_[at(i)] = body.mass * vector_of(row.data()).dot(vector_of(moved.dp));
      // That of an angular acceleration is its torque times the rotation vector, in the principal frame.
      const Vec3 alpha = vector_of(row.data() + 4);
      if (!alpha.isZero(0)) {
        const Mat3 R_BW = rotation_matrix(bodies.q[at(i)]).transpose();
        work_[at(i)] += body.moments.cwiseProduct(R_BW * alpha).dot(R_BW * vector_of(moved.dr));
      }
      begin_[at(i)] += work_[at(i)];
    }
  });
}

void EnergyBound::hold(BulkContacts& contacts, const Executor& executor, ManifoldMemories& memory,
                       BulkBodies& bodies) {
  if (!find_gains(contacts.manifolds(), memory, bodies, executor)) return;
  find_islands(contacts, memory, bodies);
  empty_springs(contacts.manifolds(), memory, bodies);
  lessen_impulses(contacts, bodies);
  for (const IslandGain& island : gains_) {
    if (is_taken(island)) calm(island, bodies);
  }
}

/// What nothing explains, of each body; whether it is more than rounding.
bool EnergyBound::find_gains(const StepManifolds& manifolds, const ManifoldMemories& memory,
                             const BulkBodies& bodies, const Executor& executor) {
  gain_.resize(bodies.x.size());
  executor.for_ranges(bodies.count(), 1024, [&](int begin, int end) {
    for (int i = begin; i < end; ++i)
      gain_[at(i)] = bodies.is_dynamic(i) ? kinetic_energy(*model_, i, bodies) - begin_[at(i)] : 0;
  });
  // The gains of bodies and springs, without what others lose, bound those of all islands; most steps end
  // here.
  double gained = 0, scale = 0;
  for (int i = 0; i < bodies.count(); ++i) {
    gained += std::max(0.0, gain_[at(i)]);
    scale += std::abs(begin_[at(i)]) + lift_[at(i)];
  }
  for (std::size_t i = 0; i < manifolds.size(); ++i)
    gained += std::max(0.0, grown_energy(manifolds, memory, i));
  return gained > rounding * scale;
}

bool EnergyBound::is_taken(const IslandGain& island) const {
  return island.is_known && island.gain > rounding * island.scale;
}

/// Number of the island of a manifold.
int EnergyBound::island_of(const StepManifolds& manifolds, std::size_t i, const BulkBodies& bodies) const {
  const int a = manifolds.body_A(i), b = manifolds.body_B(i);
  return islands_.island_of(bodies.is_dynamic(a) ? a : b);
}

/// The islands of bodies that have manifolds, with what their springs have come to hold; and those that fly
/// alone and have gained: rotations by several radians a substep are not exact.
void EnergyBound::find_islands(const BulkContacts& contacts, const ManifoldMemories& memory,
                               const BulkBodies& bodies) {
  const StepManifolds& manifolds = contacts.manifolds();
  islands_.build(manifolds);
  gains_.clear();
  gain_at_.assign(bodies.x.size(), -1);
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    // Each manifold adds the growth of its spring to its island.
    int& number = gain_at_[at(island_of(manifolds, i, bodies))];
    if (number < 0) {
      number = static_cast<int>(gains_.size());
      gains_.emplace_back();
    }
    IslandGain& island = gains_[at(number)];
    const double grown = grown_energy(manifolds, memory, i);
    island.gain += grown;
    island.stored += std::max(0.0, grown);
    const int a = manifolds.body_A(i), b = manifolds.body_B(i);
    // An impulse against something fixed changes the momentum of the island; what moves by itself may do any
    // work on it.
    if (bodies.is_dynamic(a) && bodies.is_dynamic(b)) continue;
    const ManifoldMemories::View view = memory.view(i);
    for (int k = 0; k < view.point_count; ++k)
      island.is_pressed = island.is_pressed || view.normal_impulse[k] > 0;
    if (bodies.has_velocity(bodies.is_dynamic(a) ? b : a)) island.is_known = false;
  }
  // What pressed on something fixed in an earlier substep shows in the sums.
  const auto is_wanted = [&](int a, int b, bool, bool is_pressed) {
    return is_pressed && !(bodies.is_dynamic(a) && bodies.is_dynamic(b));
  };
  contacts.for_contacts(is_wanted, [&](const SolvedManifold& manifold, std::size_t) {
    const bool is_A = bodies.is_dynamic(manifold.body_A);
    IslandGain& island =
        gains_[at(gain_at_[at(islands_.island_of(is_A ? manifold.body_A : manifold.body_B))])];
    for (const float impulse : manifold.impulses.normal) island.is_pressed = island.is_pressed || impulse > 0;
  });
  for (int i = 0; i < bodies.count(); ++i) {
    if (!bodies.is_dynamic(i)) continue;
    const int number = gain_at_[at(islands_.island_of(i))];
    if (number < 0) {
      const bool is_alone = is_jointed_[at(i)] == 0 && is_unknown_[at(i)] == 0;
      // Nothing but its own rotation can have given energy to a body that is alone.
      if (is_alone) gains_.push_back({gain_[at(i)], std::abs(begin_[at(i)]), 0, true, false, {i}});
      continue;
    }
    IslandGain& island = gains_[at(number)];
    // Each body adds its gain, and the energies that tell what of it is rounding.
    island.bodies.push_back(i);
    island.gain += gain_[at(i)];
    island.scale += std::abs(begin_[at(i)]) + lift_[at(i)];
    if (is_unknown_[at(i)] != 0) island.is_known = false;
    if (is_anchored_[at(i)] != 0) island.is_pressed = true;
  }
}

/// Springs hold no more than was paid: what forces of impacts over linear displacements say may be more.
void EnergyBound::empty_springs(const StepManifolds& manifolds, ManifoldMemories& memory,
                                const BulkBodies& bodies) {
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    const IslandGain& island = gains_[at(gain_at_[at(island_of(manifolds, i, bodies))])];
    const double grown = grown_energy(manifolds, memory, i);
    if (!is_taken(island) || !(grown > 0)) continue;
    // All springs of the island give up the same part of what they have come to hold.
    const double part = std::max(0.0, 1 - island.gain / island.stored);
    memory.set_energy(i, static_cast<float>(static_cast<double>(manifolds.energy(i)) + part * grown));
  }
  for (IslandGain& island : gains_) {
    if (island.gain > rounding * island.scale) island.gain -= std::min(island.gain, island.stored);
  }
}

/// Where the impulses of contacts are what has given too much, they all become less by one part: with D the
/// velocities that they have given and p the part that they lose,
///   E(p) - E(0) = p² ½ D·M D - p V·M D,
/// and p is the least that takes the gain, or what takes most.
void EnergyBound::lessen_impulses(BulkContacts& contacts, BulkBodies& bodies) {
  if (std::none_of(gains_.begin(), gains_.end(), [&](const IslandGain& island) { return is_taken(island); }))
    return;
  // D, as momenta first.
  given_.assign(bodies.x.size(), {});
  const auto is_wanted = [](int, int, bool, bool is_pressed) { return is_pressed; };
  contacts.for_contacts(is_wanted, [&](const SolvedManifold& manifold, std::size_t) {
    const ManifoldWrench on_B = total_wrench(manifold);
    Wrench &A = given_[at(manifold.body_A)], &B = given_[at(manifold.body_B)];
    A.f_W -= on_B.impulse;
    A.tau_W -= on_B.moment + manifold.frame.rA.cross(on_B.impulse);
    B.f_W += on_B.impulse;
    B.tau_W += on_B.moment + manifold.frame.rB.cross(on_B.impulse);
  });
  lost_part_.assign(bodies.x.size(), 0);
  for (IslandGain& island : gains_) {
    if (!is_taken(island)) continue;
    // The coefficients of the parabola above; D becomes velocities.
    double square = 0, slope = 0;
    for (const int i : island.bodies) {
      Wrench& given = given_[at(i)];
      // What joints hold passes on to them what acts on it.
      if (!bodies.gives_way(i)) {
        given = {};
        continue;
      }
      const Body& body = model_->body(i);
      const Mat3 R_WB = rotation_matrix(bodies.q[at(i)]);
      const Vec3 w = R_WB * (R_WB.transpose() * given.tau_W).cwiseQuotient(body.moments);
      square += 0.5 * (given.f_W.squaredNorm() / body.mass + w.dot(given.tau_W));
      slope += given.f_W.dot(vector_of(bodies.motion[at(i)].v)) +
               given.tau_W.dot(vector_of(bodies.motion[at(i)].w));
      given = {given.f_W / body.mass, w};
    }
    if (!(slope > 0)) continue;
    // Its smaller root in the form that does not cancel, or its lowest point where it does not come down so
    // far.
    const double rest = slope * slope - 4 * square * island.gain;
    const double part =
        std::min(1.0, rest > 0 ? 2 * island.gain / (slope + std::sqrt(rest)) : 0.5 * slope / square);
    island.gain -= part * (slope - part * square);
    for (const int i : island.bodies) {
      lost_part_[at(i)] = static_cast<float>(part);
      MotionRecord& motion = bodies.motion[at(i)];
      for (int k = 0; k < 3; ++k) {
        motion.v[k] -= static_cast<float>(part * given_[at(i)].f_W[k]);
        motion.w[k] -= static_cast<float>(part * given_[at(i)].tau_W[k]);
      }
      set_momentum(*model_, i, bodies);
    }
  }
  contacts.lessen([&](int a, int b) { return std::max(lost_part_[at(a)], lost_part_[at(b)]); });
}

/// The kinetic energy of the bodies against a rigid motion [J].
double EnergyBound::energy_against(const CommonMotion& common, const IslandGain& island,
                                   const BulkBodies& bodies) const {
  double energy = 0;
  for (const int i : island.bodies) {
    const Body& body = model_->body(i);
    const Mat3 R_BW = rotation_matrix(bodies.q[at(i)]).transpose();
    const Vec3 v = vector_of(bodies.motion[at(i)].v) - common.velocity_at(bodies.x[at(i)]);
    const Vec3 w = R_BW * (vector_of(bodies.motion[at(i)].w) - common.W);
    energy += 0.5 * (body.mass * v.squaredNorm() + w.dot(body.moments.cwiseProduct(w)));
  }
  return energy;
}

/// Takes the gain of an island from the motion of its bodies against each other.
void EnergyBound::calm(const IslandGain& island, BulkBodies& bodies) const {
  // Something fixed may have changed all momenta. Of a free island the impulses of a step, whose arms turn
  // meanwhile, may have changed the angular momentum by more than can be taken: it is not kept then.
  CommonMotion common;
  if (!island.is_pressed) {
    common = common_motion(*model_, island.bodies, bodies);
    if (energy_against(common, island, bodies) < island.gain) common.W.setZero();
  }

  // The part of the velocities that leaves the rest of their energy.
  const double energy = energy_against(common, island, bodies);
  const double part = energy > island.gain ? std::sqrt(1 - island.gain / energy) : 0;
  keep_part_of_motion(*model_, island.bodies, common, part, bodies);
  if (island.is_pressed && island.gain > energy) go_back(island, island.gain - energy, bodies);
}

/// Takes back that part of the way of an island whose lift nothing has paid for; `rest` is that lift [J]. It
/// stands, so that its momenta do not tell where it does.
void EnergyBound::go_back(const IslandGain& island, double rest, BulkBodies& bodies) const {
  double lifted = 0;
  for (const int i : island.bodies) {
    lifted -= work_[at(i)];
    if (is_jointed_[at(i)] != 0) return;  // Joints do not hold along straight ways.
  }
  if (!(lifted > 0)) return;
  const double part = std::min(1.0, rest / lifted);
  for (const int i : island.bodies) {
    const MotionRecord& motion = bodies.motion[at(i)];
    bodies.x[at(i)] -= part * vector_of(motion.dp);
    bodies.q[at(i)] = (rotation_exp(-part * vector_of(motion.dr)) * bodies.q[at(i)]).normalized();
  }
}

}  // namespace rigor
