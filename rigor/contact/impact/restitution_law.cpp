#include "rigor/contact/impact/restitution_law.hpp"

#include <array>
#include <cstddef>

namespace rigor {

namespace {

/// A new law is one more row here.
constexpr std::array rules = {
    RestitutionRule{RestitutionLaw::newton, "newton", "Newton",
                    "relative normal velocity after is -e times before",
                    "Newton, Philosophiae Naturalis Principia Mathematica, 1687", newton_restitution},
    RestitutionRule{RestitutionLaw::poisson, "poisson", "Poisson",
                    "impulse of restitution is e times that of compression",
                    "Routh, Dynamics of a System of Rigid Bodies, 1905", poisson_restitution},
    RestitutionRule{RestitutionLaw::stronge, "stronge", "Stronge",
                    "work of restitution is -e^2 times that of compression",
                    "Stronge, Rigid Body Collisions with Friction, 1990", stronge_restitution},
};

constexpr std::size_t place_of(RestitutionLaw law) {
  return static_cast<std::size_t>(law);
}
constexpr bool rows_follow_the_enumerators() {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (place_of(rules[i].law) != i) return false;
  }
  return true;
}
static_assert(rules.size() == place_of(RestitutionLaw::count), "every RestitutionLaw needs one row");
static_assert(rows_follow_the_enumerators(), "the rows stand in the order of the enumerators");

}  // namespace

std::span<const RestitutionRule> restitution_rules() {
  return rules;
}

const RestitutionRule& rule_of(RestitutionLaw law) {
  return rules[place_of(law)];
}

}  // namespace rigor
