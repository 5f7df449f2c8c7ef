#pragma once

#include "rigor/sim/islands/cluster.hpp"
#include "rigor/sim/islands/island_integrator.hpp"
#include "rigor/sim/islands/joint_projection.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <deque>
#include <mutex>
#include <vector>

namespace rigor {

/// The bodies of a part after h without contacts.
struct FreeEnd {
  std::vector<BodyPhase> phases;        ///< One a body.
  Vec3 impulse = Vec3::Zero();          ///< Of all forces from outside [N s].
  Vec3 angular_impulse = Vec3::Zero();  ///< About the origin of W [N m s].
  WorkDone work;                        ///< [J].
};

/// The free motions of the tries of one step. They do not depend on contacts: bodies that begin as in an
/// earlier try, bit for bit, end as there. Several threads may ask at once; what they get does not depend on
/// who was first.
class FreeMotionMemory {
 public:
  struct Question {
    const Environment* environment;  ///< The forces.
    double h;                        ///< [s].
    std::vector<int> bodies;
    std::vector<BodyPhase> phases;
  };
  struct Known {
    Question question;
    FreeEnd end;
    AdvanceReport report;
  };
  /// Forgets all: another step begins.
  void clear() { known_.clear(); }
  /// None if it is not known; valid until clear().
  const Known* find(const Question& question);
  const Known& keep(Known known);

 private:
  std::mutex mutex_;
  std::deque<Known> known_;  ///< Places stay valid while it grows.
};

/// The smooth motion of a step without contacts, under the forces of an environment. Each set of bodies that
/// joints and springs connect moves by itself: in closed form where only steady forces act, else in as many
/// steps of the integrator as the error of this set asks for, put back on its joints after each.
class FreeMotion {
 public:
  FreeMotion(const Model& model, const Environment& environment, const ContactSystemAssembler& assembler,
             const JointProjection& joints, const Method& method);

  /// All bodies of the part after h [s]. memory: of the tries of this step.
  FreeEnd fly(double h, const Cluster& part, FreeMotionMemory& memory, AdvanceReport& report) const;

 private:
  void fly_freely(double h, int body, BodyPhase& phase, FreeEnd& end) const;
  FreeEnd integrate(double h, const Cluster& part, AdvanceReport& report) const;

  const Model& model_;
  const Environment& environment_;
  IslandIntegrator integrator_;
  const JointProjection& joints_;
};

}  // namespace rigor
