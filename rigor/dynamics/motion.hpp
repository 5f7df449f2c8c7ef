#pragma once

#include "rigor/dynamics/body_phase.hpp"
#include "rigor/dynamics/free_flight.hpp"
#include "rigor/dynamics/integrator.hpp"
#include "rigor/geometry/motion/rigid_motion.hpp"
#include "rigor/geometry/shape/aabb.hpp"
#include "rigor/math/pose.hpp"
#include "rigor/model/model.hpp"

#include <limits>
#include <variant>

namespace rigor {

/// The smooth motion of one body over a span of time, with bounds that hold for all of it, on which the
/// search for the next impact relies. The body is at rest, has a prescribed path, is in closed-form flight,
/// or moves along one step of an integrator.
class Motion : public RigidMotion {
 public:
  /// Kinematic or fixed body from time t to the next point of its path.
  static Motion prescribed(const Body& body, double t);
  /// Dynamic body that stays at rest: all forces balance.
  static Motion at_rest(const BodyPhase& phase, double t);
  /// Dynamic body in closed-form flight.
  static Motion flight(const FreeFlight& flight, const BodyInertia& inertia);
  /// Dynamic body over one integrator step of size h from t.
  static Motion step(const DensePhase& dense, double t, double h);

  double begin() const { return begin_; }
  double end() const { return end_; }  ///< Infinite unless the motion is a step or a leg of a path.

  /// Along a step the velocities are those of the path, the derivatives of its polynomials (its momenta agree
  /// with them to the order of the method).
  Sample sample(double t) const override;
  Vec3 position(double t) const;
  Vec3 velocity(double t) const override;  ///< Of the centre of mass [m/s].
  BodyPhase phase(double t) const;         ///< Momenta are zero for prescribed motion.

  bool is_dynamic() const { return !std::holds_alternative<Prescribed>(path_); }
  /// Whether the centre moves with this constant acceleration exactly.
  bool is_ballistic() const { return !std::holds_alternative<Step>(path_); }
  Vec3 acceleration() const;  ///< Of a ballistic motion [m/s²].

  /// Lower bound over [ta, tb] of the acceleration of the centre along n [m/s²].
  double min_acceleration_along(const Vec3& n, double ta, double tb) const override;
  /// Upper bound over the whole motion of |ω| [rad/s].
  double max_angular_speed() const override { return max_angular_speed_; }
  /// Upper bound over the whole motion of |α| + |ω|² [1/s²]: a point at distance r from the centre
  /// accelerates relative to it by at most r times this.
  double max_turn_acceleration() const override { return max_turn_acceleration_; }
  /// Box that holds the centre over [ta, tb].
  Aabb path_box(double ta, double tb) const;

 private:
  struct Prescribed {
    const Body* body;
    Vec3 v, w;
  };
  struct Rest {
    BodyPhase phase;
  };
  struct Flight {
    FreeFlight flight;
    BodyInertia inertia;
  };
  struct Step {
    DensePhase dense;
  };
  Vec3 step_angular_velocity(double t) const;
  double theta(double t) const { return (t - begin_) / (end_ - begin_); }

  std::variant<Rest, Prescribed, Flight, Step> path_;
  double begin_ = 0;
  double end_ = std::numeric_limits<double>::infinity();
  double max_angular_speed_ = 0;
  double max_turn_acceleration_ = 0;
};

}  // namespace rigor
