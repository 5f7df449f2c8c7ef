#pragma once

#include "rigor/contact/impact/restitution_law.hpp"

#include <span>
#include <string_view>

namespace rigor {

struct ContactSystem;
struct ImpactProblem;
struct ImpactSolution;

/// How several impacts at one instant are resolved. Each law is a row of the table in impact.cpp and files of
/// its own.
enum class SimultaneousLaw {
  reflections,  ///< Generalised reflections blended with the plastic impact: symmetric, never gains energy.
  lcp,  ///< Newton's law on all contacts at once: may gain energy and transmits too little through chains.
  sequential,  ///< One after the other, the fastest first.
  projection,  ///< The velocities of lcp as the nearest that the contacts allow, in motion space.
  moreau,      ///< The same projection, passed beyond by e: never gains energy.
  count,       ///< The number of laws, not a law.
};

/// One row of the table of laws.
struct SimultaneousRule {
  SimultaneousLaw law;
  std::string_view name;     ///< In scene files: "reflections".
  std::string_view meaning;  ///< One line.
  std::string_view source;   ///< Where the law is from.
  /// Whether contacts that make one collision are resolved as that one, by the law of a single collision.
  bool joins_contacts;
  /// The law. (A reference: a row without it does not compile.)
  ImpactSolution (&solve)(const ContactSystem& system, const ImpactProblem& problem,
                          RestitutionLaw collision_law);
};

/// All laws, in the order of the enumerators.
std::span<const SimultaneousRule> simultaneous_rules();

}  // namespace rigor
