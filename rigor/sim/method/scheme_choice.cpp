#include "rigor/sim/method/scheme_choice.hpp"

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/sim/method/colliding_bodies.hpp"
#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace rigor {

namespace {

/// A heap of this many bouncing balls takes the event-driven engine ten seconds per simulated second
/// (docs/choosing.md).
constexpr int few_bodies = 40;

/// So many bodies that rest on each other may be one island, whose contacts are one dense system.
constexpr int bodies_of_one_island = 200;

/// All restitutions between shapes of the body and shapes of these materials.
std::set<double> restitutions_of(const Model& model, int i, const std::set<int>& materials) {
  std::set<double> restitutions;
  for (const BodyShape& shape : model.body(i).shapes) {
    for (const int other : materials)
      restitutions.insert(model.coefficients(shape.material, other).restitution);
  }
  return restitutions;
}

std::set<int> materials_of_shapes(const Model& model) {
  std::set<int> materials;
  for (const Body& body : model.bodies()) {
    for (const BodyShape& shape : body.shapes) materials.insert(shape.material);
  }
  return materials;
}

/// The pairs that touch at t = 0, and their bodies.
struct Touching {
  int pairs = 0;
  int bouncing_pairs = 0;  ///< Those of them whose restitution is between 0 and 1.
  std::set<int> bodies;
};

bool is_between_0_and_1(double restitution) {
  return restitution > 0 && restitution < 1;
}

/// Adds the pair of bodies if any of their shapes touch.
void add_pair(const Model& model, const State& state, int a, int b, double tolerance, Touching& touching) {
  const Pose X_WA = pose_of(state, a), X_WB = pose_of(state, b);
  bool is_touching = false, bounces = false;
  for (const BodyShape& of_A : model.body(a).shapes) {
    for (const BodyShape& of_B : model.body(b).shapes) {
      if (signed_distance(of_A.shape, X_WA * of_A.X_BS, of_B.shape, X_WB * of_B.X_BS).distance > tolerance)
        continue;
      is_touching = true;
      bounces |= is_between_0_and_1(model.coefficients(of_A.material, of_B.material).restitution);
    }
  }
  if (!is_touching) return;
  ++touching.pairs;
  if (bounces) ++touching.bouncing_pairs;
  touching.bodies.insert({a, b});
}

Touching find_touching(const Model& model, double tolerance) {
  const State state = make_initial_state(model);
  Touching touching;
  for (const auto& [a, b] : near_pairs(model, state, tolerance))
    add_pair(model, state, a, b, tolerance, touching);
  return touching;
}

void add_restitutions(const Model& model, const std::vector<int>& colliding, const std::set<int>& touching,
                      SchemeFacts& facts) {
  const std::set<int> materials = materials_of_shapes(model);
  std::set<double> all;
  for (const int i : colliding) {
    const std::set<double> own = restitutions_of(model, i, materials);
    all.insert(own.begin(), own.end());
    if (!touching.contains(i) && std::any_of(own.begin(), own.end(), is_between_0_and_1))
      ++facts.bouncing_apart;
  }
  if (all.empty()) return;
  facts.lowest_restitution = *all.begin();
  facts.highest_restitution = *all.rbegin();
}

bool has_drag(const Body& body) {
  return body.motion == MotionType::dynamic && (body.linear_drag > 0 || body.angular_drag > 0 ||
                                                body.linear_damping > 0 || body.angular_damping > 0);
}

const SchemeRefusal* refusal_of(Scheme scheme, std::span<const SchemeRefusal> refusals) {
  const auto found = std::find_if(refusals.begin(), refusals.end(),
                                  [&](const SchemeRefusal& each) { return each.scheme == scheme; });
  return found == refusals.end() ? nullptr : &*found;
}

/// "3 dynamic bodies, 2 may collide; 1 pair touches at t = 0; 0 joints; restitution 0.5".
std::string facts_text(const SchemeFacts& facts) {
  std::string text =
      fmt::format("{} dynamic {}, {} may collide; {} {} at t = 0; {} {}; restitution {}",
                  facts.dynamic_bodies, facts.dynamic_bodies == 1 ? "body" : "bodies", facts.colliding_bodies,
                  facts.touching_pairs, facts.touching_pairs == 1 ? "pair touches" : "pairs touch",
                  facts.joints, facts.joints == 1 ? "joint" : "joints", facts.lowest_restitution);
  if (facts.highest_restitution > facts.lowest_restitution)
    text += fmt::format(" to {}", facts.highest_restitution);
  return text;
}

}  // namespace

SchemeFacts scheme_facts(const Model& model, double contact_tolerance) {
  SchemeFacts facts;
  const std::vector<Body>& bodies = model.bodies();
  facts.dynamic_bodies = static_cast<int>(std::count_if(
      bodies.begin(), bodies.end(), [](const Body& body) { return body.motion == MotionType::dynamic; }));
  const std::vector<int> colliding = colliding_bodies(model);
  facts.colliding_bodies = static_cast<int>(colliding.size());
  const Touching touching = find_touching(model, contact_tolerance);
  facts.touching_pairs = touching.pairs;
  facts.bouncing_pairs = touching.bouncing_pairs;
  const State start = make_initial_state(model);
  facts.resting_bodies = static_cast<int>(std::count_if(colliding.begin(), colliding.end(), [&](int i) {
    return touching.bodies.contains(i) && start.linear_momentum(i).isZero(0) &&
           start.angular_momentum(i).isZero(0);
  }));
  facts.joints = static_cast<int>(model.joints().size());
  facts.has_closed_form = model.joints().empty() && model.forces().empty() && model.drives().empty() &&
                          std::none_of(bodies.begin(), bodies.end(), has_drag);
  add_restitutions(model, colliding, touching.bodies, facts);
  return facts;
}

std::span<const SchemeRule> scheme_rules() {
  static const std::array<SchemeRule, 8> rules = {{
      {"nothing collides and only gravity acts",
       [](const SchemeFacts& facts) { return facts.colliding_bodies == 0 && facts.has_closed_form; },
       {Scheme::event_driven},
       "the motion is known in closed form, and no sub-problem is ever solved"},
      {"nothing collides",
       [](const SchemeFacts& facts) { return facts.colliding_bodies == 0; },
       {Scheme::event_driven},
       "the sub-problems are solved at the stages of the integrator, whose order event-driven keeps"},
      {"only gravity acts, nothing touches at t = 0 and no impact dissipates energy (restitution 1)",
       [](const SchemeFacts& facts) {
         return facts.has_closed_form && facts.touching_pairs == 0 && facts.lowest_restitution == 1;
       },
       {Scheme::event_driven},
       "nothing comes to rest: one sub-problem per impact, and closed forms in between"},
      {"at most 40 bodies collide, some touch at t = 0 and some are apart, all with restitutions between 0 "
       "and 1",
       [](const SchemeFacts& facts) {
         return facts.colliding_bodies <= few_bodies && facts.bouncing_pairs > 0 && facts.bouncing_apart > 0;
       },
       {Scheme::hybrid, Scheme::event_driven},
       "bouncing bodies fall on resting ones, which must not bounce in each of their impacts"},
      {"at most 40 bodies collide",
       [](const SchemeFacts& facts) { return facts.colliding_bodies <= few_bodies; },
       {Scheme::event_driven},
       "few bodies have few events, and each is located and solved by itself"},
      {"at most 200 bodies collide, and all of them touch and are at rest at t = 0",
       [](const SchemeFacts& facts) {
         return facts.colliding_bodies <= bodies_of_one_island &&
                facts.resting_bodies == facts.colliding_bodies;
       },
       {Scheme::event_driven},
       "what rests has no events"},
      {"more bodies collide, and some impacts bounce",
       [](const SchemeFacts& facts) { return facts.highest_restitution > 0; },
       {Scheme::hybrid, Scheme::time_stepping, Scheme::event_driven},
       "many bounce and many rest: an impulse for each brief contact, constraints for the lasting ones"},
      {"more bodies collide, and none bounces",
       [](const SchemeFacts&) { return true; },
       {Scheme::time_stepping, Scheme::hybrid, Scheme::event_driven},
       "contacts last: one sub-problem per step for all of them, however many events there are"},
  }};
  return rules;
}

namespace {

/// Which of these schemes refuse the scene, with their first reasons.
std::vector<SchemeRefusal> refusals_among(const std::vector<Scheme>& schemes, const Model& model,
                                          const Method& method) {
  std::vector<SchemeRefusal> refusals;
  for (const Scheme scheme : schemes) {
    Method candidate = method;
    candidate.scheme = scheme;
    std::vector<std::string> reasons = check_scheme(model, candidate);
    if (reasons.empty()) reasons = check_combination(candidate);
    if (!reasons.empty()) refusals.push_back({scheme, std::move(reasons.front())});
  }
  return refusals;
}

/// The first rule that applies; one does.
const SchemeRule& rule_of(const SchemeFacts& facts) {
  const std::span<const SchemeRule> rules = scheme_rules();
  return *std::find_if(rules.begin(), rules.end(),
                       [&](const SchemeRule& each) { return each.applies(facts); });
}

}  // namespace

std::vector<SchemeRefusal> scheme_refusals(const Model& model, const Method& method) {
  return refusals_among(all_schemes(), model, method);
}

SchemeChoice choose_scheme(const SchemeFacts& facts, std::span<const SchemeRefusal> refusals) {
  const SchemeRule& rule = rule_of(facts);
  std::vector<Scheme> candidates = rule.schemes;
  const std::vector<Scheme> others = all_schemes();
  candidates.insert(candidates.end(), others.begin(), others.end());
  const auto chosen = std::find_if(candidates.begin(), candidates.end(),
                                   [&](Scheme each) { return !refusal_of(each, refusals); });
  const Scheme scheme = chosen == candidates.end() ? Scheme::event_driven : *chosen;
  std::string reason =
      fmt::format("{}, since {}: {} ({})", scheme_name(scheme), rule.when, rule.why, facts_text(facts));
  for (const Scheme better : rule.schemes) {
    if (better == scheme) break;
    reason += fmt::format("; {} would be preferred but refuses the scene: {}", scheme_name(better),
                          refusal_of(better, refusals)->reason);
  }
  return {scheme, std::move(reason)};
}

std::vector<Scheme> all_schemes() {
  static const std::vector<Scheme> known = [] {
    std::vector<Scheme> schemes;
    for (const std::string& name : method_values("scheme")) {
      Method method;
      set_method_choice("scheme", name, method);
      if (method.scheme != Scheme::automatic) schemes.push_back(method.scheme);
    }
    return schemes;
  }();
  return known;
}

ResolvedMethod resolve_scheme(const Model& model, const Method& method) {
  if (method.scheme != Scheme::automatic) return {method, {}};
  // The schemes that a rule prefers are asked, and the others only if all of these refuse.
  const SchemeFacts facts = scheme_facts(model, method.contact_tolerance);
  const std::vector<Scheme>& preferred = rule_of(facts).schemes;
  std::vector<Scheme> asked = preferred;
  asked.push_back(Scheme::time_stepping);
  std::vector<SchemeRefusal> refusals = refusals_among(asked, model, method);
  const auto is_refused = [&](Scheme scheme) { return refusal_of(scheme, refusals) != nullptr; };
  if (std::ranges::all_of(preferred, is_refused)) refusals = scheme_refusals(model, method);
  SchemeChoice choice = choose_scheme(facts, refusals);
  ResolvedMethod resolved{method, std::move(choice.reason)};
  resolved.method.scheme = choice.scheme;

  // Where events may crowd, time stepping stands by; sub-steps are another path with weaker promises.
  const bool has_events = choice.scheme == Scheme::event_driven || choice.scheme == Scheme::hybrid;
  if (has_events && method.solver != SolverMethod::substep && !refusal_of(Scheme::time_stepping, refusals)) {
    resolved.steps = method;
    resolved.steps->scheme = Scheme::time_stepping;
  }

  // Where exact steps may take too long, soft ones stand by.
  const bool has_steps = resolved.steps || choice.scheme == Scheme::time_stepping;
  if (!has_steps || method.solver != SolverMethod::exact || method.cone != ConeMethod::exact ||
      method.last_resort == LastResort::none)
    return resolved;
  Method soft = method;
  soft.scheme = Scheme::time_stepping;
  soft.solver = SolverMethod::substep;
  if (check_scheme(model, soft).empty() && check_combination(soft).empty()) resolved.soft_steps = soft;
  return resolved;
}

}  // namespace rigor
