#pragma once

#include "rigor/contact/impact/restitution_law.hpp"
#include "rigor/contact/impact/simultaneous_law.hpp"
#include "rigor/core/range.hpp"
#include "rigor/dynamics/orientation_form.hpp"
#include "rigor/geometry/broad_phase/broad_phase_method.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// `automatic` ("auto") stands for the one that the scene's rule gives (scheme_choice.hpp).
enum class Scheme { event_driven, time_stepping, penalty, impulse_based, hybrid, automatic };
/// `exact` is the closed form (ballistic arcs and torque-free rotation); the others are numerical.
enum class IntegratorMethod { exact, euler, semi_implicit_euler, midpoint, rk4, dopri5, dop853, lie_rk4 };
enum class DistanceMethod { gjk, lin_canny };
enum class ToiMethod { conservative, ratio, bisection };
enum class RestingMethod { contact_space, motion_space };
/// The LCP solver of contact space, also where motion space hands over to it.
enum class LcpMethod { dantzig, lemke };
/// Of the impulse-based scheme: what its slow collisions do about creep (micro_collision.hpp).
enum class MicroCollisionMethod { patched, plain };
/// Springs at each contact by itself, or all of them in one system.
enum class PenaltyMethod { local, global };
/// Normal law of penalty contacts.
enum class PenaltyLaw { linear, hunt_crossley };
/// The solver of contact problems in time stepping.
enum class SolverMethod { exact, pgs, substep };
/// The friction cone of time stepping.
enum class ConeMethod { exact, convex, pyramid };
/// What `auto` does where exact steps cost more than simulated time pays for: soft sub-steps, or nothing.
enum class LastResort { substep, none };

/// Every choice of how a scene is simulated. The defaults are the best that this version offers.
struct Method {
  /// How time goes on.
  Scheme scheme = Scheme::automatic;
  /// Of motion under forces.
  IntegratorMethod integrator = IntegratorMethod::exact;
  /// Of free rotation.
  OrientationForm orientation = OrientationForm::quaternion;
  /// Which pairs are near.
  BroadPhaseMethod broad_phase = BroadPhaseMethod::tree;
  /// Of two convex shapes.
  DistanceMethod distance = DistanceMethod::gjk;
  /// Time of the next contact.
  ToiMethod toi = ToiMethod::conservative;
  /// Law of collisions.
  RestitutionLaw impact = RestitutionLaw::stronge;
  /// Several collisions at one instant.
  SimultaneousLaw simultaneous = SimultaneousLaw::reflections;
  /// Forces of lasting contacts.
  RestingMethod resting = RestingMethod::motion_space;
  /// Solver of complementarity problems.
  LcpMethod lcp = LcpMethod::dantzig;
  /// Collisions of impulse-based contacts.
  MicroCollisionMethod micro_collisions = MicroCollisionMethod::patched;
  /// Kind of the springs' integration.
  PenaltyMethod penalty = PenaltyMethod::local;
  /// Law of the springs.
  PenaltyLaw penalty_law = PenaltyLaw::linear;
  /// Of the steps of time stepping.
  SolverMethod solver = SolverMethod::exact;
  /// Of friction.
  ConeMethod cone = ConeMethod::exact;
  /// Of `auto` where exact steps take too long.
  LastResort last_resort = LastResort::substep;
  bool sleeping = false;            ///< Bodies at rest are left alone (solver substep).
  double contact_tolerance = 1e-6;  ///< Pairs closer than this touch [m].
  double time_tolerance = 1e-12;    ///< Width of a time of impact [s].
  double resting_velocity = 1e-3;   ///< Slower approaches do not bounce [m/s].
  double tolerance = 1e-10;         ///< Relative local error of dopri5 and dop853.
  double penalty_depth = 1e-4;      ///< How deep an impact presses a penalty contact [m].
  double stiffness = 0;             ///< Stiffness of penalty contacts [N/m]; 0: from penalty_depth.
  double damping = 0;               ///< Their damping [N s/m]; 0: from the restitution of the pair.
  /// Sub-steps of a step: least number of the penalty scheme, number of solver substep; 0: 1 or 6.
  double substeps = 0;
  double iterations = 50;  ///< Sweeps of solver pgs per contact problem, a whole number.

  /// Choice by choice and number by number.
  bool operator==(const Method& other) const = default;
};

/// One named value of a choice, as `rigor methods` lists it.
struct MethodChoice {
  std::string_view key;      ///< "impact".
  std::string_view value;    ///< "newton".
  std::string_view meaning;  ///< One line.
  std::string_view source;   ///< Where the method is from.
};

/// One number of the method.
struct MethodNumber {
  std::string_view key;  ///< "contact_tolerance".
  /// "s", "m" and so on.
  std::string_view unit;
  std::string_view fallback;  ///< Default as text.
  /// What is allowed.
  Range range;
  /// For the documentation.
  std::string_view meaning;
  /// Where a Method has it.
  double Method::*member;
};

/// All values of all choices, grouped by key, in the order of the documentation.
std::span<const MethodChoice> method_choices();
/// All numbers.
std::span<const MethodNumber> method_numbers();
/// Keys of the choices in the order of the documentation.
std::vector<std::string> method_choice_keys();
/// Values of a choice, in the order of its enumerators; none for an unknown key.
std::vector<std::string> method_values(std::string_view key);

/// Sets the named choice. Returns nothing, or the error: "unknown impact 'newtn'; did you mean 'newton'?".
std::string set_method_choice(std::string_view key, std::string_view value, Method& method);

/// The name of the value that the method has chosen for a key ("newton"); empty for an unknown key.
std::string method_choice(const Method& method, std::string_view key);

/// The name of a scheme ("event-driven").
std::string scheme_name(Scheme scheme);

/// What is wrong with the combination of choices, each message naming the values that go together; empty if
/// nothing is.
std::vector<std::string> check_combination(const Method& method);

}  // namespace rigor
