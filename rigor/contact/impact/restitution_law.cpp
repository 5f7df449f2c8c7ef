#include "rigor/contact/impact/restitution_law.hpp"

#include "rigor/core/index.hpp"

#include <array>
#include <cstddef>

namespace rigor {

namespace {

/// A new law is one more row here.
constexpr std::array restitution_table = {
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

constexpr bool restitution_table_is_in_order() {
  for (std::size_t i = 0; i < restitution_table.size(); ++i) {
    if (at(restitution_table[i].law) != i) return false;
  }
  return true;
}
static_assert(restitution_table.size() == at(RestitutionLaw::count), "every RestitutionLaw needs one row");
static_assert(restitution_table_is_in_order(), "the rows stand in the order of the enumerators");

}  // namespace

std::span<const RestitutionRule> restitution_rules() {
  return restitution_table;
}

const RestitutionRule& rule_of(RestitutionLaw law) {
  return restitution_table[at(law)];
}

}  // namespace rigor
