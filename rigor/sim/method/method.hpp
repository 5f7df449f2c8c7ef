#pragma once

#include "rigor/core/range.hpp"
#include "rigor/dynamics/integrator.hpp"
#include "rigor/geometry/broad_phase/broad_phase.hpp"

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
enum class ImpactMethod { newton, poisson, stronge };
enum class SimultaneousMethod { reflections, lcp, sequential, projection, moreau };
enum class RestingMethod { contact_space, motion_space };
/// Of contact space, also where motion space hands over to it.
enum class LcpMethod { dantzig, lemke };
/// Of the impulse-based scheme: what its slow collisions do about creep (micro_collision.hpp).
enum class MicroCollisionMethod { patched, plain };
/// Springs at each contact by themselves, or all together in one system.
enum class PenaltyMethod { local, global };
/// Normal law of penalty contacts.
enum class PenaltyLaw { linear, hunt_crossley };
/// Of time stepping.
enum class SolverMethod { exact, pgs, substep };
/// What stands for Coulomb's cone in time stepping.
enum class ConeMethod { exact, convex, pyramid };

/// Every choice of how a scene is simulated. The defaults are the best that this version offers.
struct Method {
  Scheme scheme = Scheme::event_driven;
  IntegratorMethod integrator = IntegratorMethod::exact;
  OrientationForm orientation = OrientationForm::quaternion;
  BroadPhaseMethod broad_phase = BroadPhaseMethod::tree;
  DistanceMethod distance = DistanceMethod::gjk;
  ToiMethod toi = ToiMethod::conservative;
  ImpactMethod impact = ImpactMethod::stronge;
  SimultaneousMethod simultaneous = SimultaneousMethod::reflections;
  RestingMethod resting = RestingMethod::motion_space;
  LcpMethod lcp = LcpMethod::dantzig;
  MicroCollisionMethod micro_collisions = MicroCollisionMethod::patched;
  PenaltyMethod penalty = PenaltyMethod::local;
  PenaltyLaw penalty_law = PenaltyLaw::linear;
  SolverMethod solver = SolverMethod::exact;
  ConeMethod cone = ConeMethod::exact;
  bool sleeping = false;            ///< Of solver substep: bodies at rest are left alone.
  double contact_tolerance = 1e-6;  ///< Pairs closer than this touch [m].
  double time_tolerance = 1e-12;    ///< Of a time of impact [s].
  double resting_velocity = 1e-3;   ///< Slower approaches do not bounce [m/s].
  double tolerance = 1e-10;         ///< Relative local error of dopri5 and dop853.
  double penalty_depth = 1e-4;      ///< How deep an impact presses a penalty contact [m].
  double stiffness = 0;             ///< Of penalty contacts [N/m]; 0: from penalty_depth.
  double damping = 0;               ///< Of penalty contacts [N s/m]; 0: from the restitution of the pair.
  double substeps = 0;     ///< In a step: at least of the penalty scheme, of solver substep; 0: 1 or 6.
  double iterations = 50;  ///< Sweeps of solver pgs in each contact problem, a whole number.

  bool operator==(const Method& other) const = default;
};

/// One named value of a choice, as `rigor methods` lists it.
struct MethodChoice {
  std::string_view key;      ///< "impact".
  std::string_view value;    ///< "newton".
  std::string_view meaning;  ///< One line.
  std::string_view source;   ///< Where the method is from.
  bool is_available;         ///< In this version.
};

/// One number of the method.
struct MethodNumber {
  std::string_view key;  ///< "contact_tolerance".
  std::string_view unit;
  std::string_view fallback;  ///< Default as text.
  Range range;
  std::string_view meaning;
  double Method::*member;
};

/// All values of all choices, grouped by key, in the order of the documentation.
std::span<const MethodChoice> method_choices();
/// All numbers.
std::span<const MethodNumber> method_numbers();
/// Keys of the choices in the order of the documentation.
std::vector<std::string> method_choice_keys();
/// Values of a choice: all, or those of this version.
std::vector<std::string> method_values(std::string_view key, bool only_available);

/// Sets the named choice. Empty, or the error: "unknown impact 'newtn'; did you mean 'newton'?" or
/// "scheme 'penalty' is not available in this version; available: event-driven".
std::string set_method_choice(std::string_view key, std::string_view value, Method& method);

/// The value's name of a choice that the method has made ("newton"); empty for an unknown key and for choices
/// of later versions.
std::string method_choice(const Method& method, std::string_view key);

/// What is wrong with the combination, each message naming the values that go together; empty if nothing.
std::vector<std::string> check_combination(const Method& method);

}  // namespace rigor
