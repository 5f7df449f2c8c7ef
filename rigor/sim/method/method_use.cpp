#include "rigor/sim/method/method_use.hpp"

#include "rigor/sim/method/method.hpp"

#include <algorithm>
#include <array>

namespace rigor {

namespace {

/// The kinds of schemes that read a choice: event-driven, impulse-based and hybrid locate impacts.
struct ChoiceUse {
  std::string_view key;
  bool when_located, when_stepped, when_penalised;
};

constexpr std::array<ChoiceUse, 10> choice_uses = {{
    {"distance", true, false, false},
    {"toi", true, false, false},
    {"impact", true, true, false},
    {"simultaneous", true, true, false},
    {"resting", true, true, true},
    {"lcp", true, true, true},
    {"penalty", false, false, true},
    {"penalty_law", false, false, true},
    {"solver", false, true, false},
    {"cone", false, true, false},
}};

}  // namespace

bool uses_choice(const Method& method, std::string_view key) {
  // The many-body path has one way for all else.
  const bool is_bulk = method.scheme == Scheme::time_stepping && method.solver == SolverMethod::substep;
  if (is_bulk) return key == "scheme" || key == "solver" || key == "sleeping";
  if (key == "sleeping") return method.scheme == Scheme::automatic;
  if (key == "last_resort") return method.scheme == Scheme::automatic;
  if (key == "micro_collisions" && method.scheme != Scheme::automatic)
    return method.scheme == Scheme::impulse_based;
  const auto use = std::find_if(choice_uses.begin(), choice_uses.end(),
                                [&](const ChoiceUse& each) { return each.key == key; });
  if (use == choice_uses.end() || method.scheme == Scheme::automatic) return true;
  if (method.scheme == Scheme::time_stepping) return use->when_stepped;
  if (method.scheme == Scheme::penalty) return use->when_penalised;
  return use->when_located;
}

}  // namespace rigor
