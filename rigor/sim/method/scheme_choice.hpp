#pragma once

#include "rigor/sim/method/method.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

class Model;

/// The facts of a scene on which the choice of a scheme rests: of the Model and its start, so that they never
/// change in a run.
struct SchemeFacts {
  int dynamic_bodies = 0;
  int colliding_bodies = 0;  ///< Dynamic bodies that may touch any other body.
  int touching_pairs = 0;    ///< Pairs of bodies that touch at t = 0.
  int bouncing_pairs = 0;    ///< Those of them whose restitution is between 0 and 1.
  /// Colliding bodies that touch nothing at t = 0, with a restitution between 0 and 1.
  int bouncing_apart = 0;
  int resting_bodies = 0;  ///< Colliding bodies that touch something at t = 0 and do not move.
  int joints = 0;
  bool has_closed_form = false;    ///< Nothing but gravity acts between contacts.
  double lowest_restitution = 0;   ///< Of the materials of bodies that may touch; 0 if none may.
  double highest_restitution = 0;  ///< The same.
};

/// The facts of a model. contact_tolerance [m]: pairs closer than this touch.
SchemeFacts scheme_facts(const Model& model, double contact_tolerance);

/// One line of the table by which `scheme: auto` chooses: the first that applies decides. docs/choosing.md
/// shows the same table.
struct SchemeRule {
  std::string_view when;  ///< "at most 40 bodies collide".
  bool (*applies)(const SchemeFacts& facts);
  std::vector<Scheme> schemes;  ///< The first one that does not refuse the scene is taken.
  std::string_view why;
};

/// The table; its last line always applies, and every line ends with event-driven.
std::span<const SchemeRule> scheme_rules();

/// The scheme that was chosen, and why, in a sentence without its full stop.
struct SchemeChoice {
  Scheme scheme;
  std::string reason;
};

/// A scheme that cannot run the scene, and why.
struct SchemeRefusal {
  Scheme scheme;
  std::string reason;  ///< As check_scheme and check_combination say it.
};

/// All schemes, in the order of the enumerators; `auto` is not one of them.
std::vector<Scheme> all_schemes();

/// The schemes that do not go with the model or with the rest of the method.
std::vector<SchemeRefusal> scheme_refusals(const Model& model, const Method& method);

/// The first scheme of the first rule that applies which does not refuse the scene; if all schemes of the
/// rule refuse, the first of the others that does not. Event-driven if every scheme refuses.
SchemeChoice choose_scheme(const SchemeFacts& facts, std::span<const SchemeRefusal> refusals = {});

/// The method with the scheme that `auto` stands for in this scene, and the reason; a method that names its
/// scheme stays as it is, without a reason. The same Model always gives the same answer.
struct ResolvedMethod {
  Method method;
  std::string scheme_reason;
  /// The method of time stepping, to which `auto` hands over where events crowd; nothing if the method names
  /// its scheme, if that which was chosen has no events, if time stepping refuses the scene, or if its solver
  /// would be `substep`.
  std::optional<Method> steps = {};
  /// The method of soft steps, to which `auto` hands over where exact ones take too long; nothing if the
  /// method names its scheme or another solver, has no last resort, or sub-steps refuse the scene.
  std::optional<Method> soft_steps = {};
};
ResolvedMethod resolve_scheme(const Model& model, const Method& method);

}  // namespace rigor
