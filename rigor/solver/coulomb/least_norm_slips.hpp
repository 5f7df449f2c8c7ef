#pragma once

#include "rigor/solver/coulomb/coulomb_guess.hpp"

#include <functional>
#include <optional>

namespace rigor {

/// The solution with the given modes whose forces are of least norm in the cones, if its residual is at most
/// `accepted`.
///
/// Mostly one linear solve. But where redundant contacts slide in different directions, other forces make
/// other slips: wanted are slips û such that the forces of least norm for û make motions w_t along û. This
/// fixed point of the map (slip angles → forces → slip angles) is found by Anderson's acceleration from the
/// slips in `face`. Nothing if it was not found, or a contact stops or reverses on the way.
std::optional<CoulombSolution> find_least_norm(const CoulombProblem& problem, const ContactModes& face,
                                               double accepted);

/// The solution with forces of least norm in the cones for modes with known slips, if there are such forces.
using ForcesOfModes = std::function<std::optional<CoulombSolution>(const ContactModes&)>;

/// The same with any way to find the forces; of `laws` A is not read.
std::optional<CoulombSolution> find_least_norm(const CoulombProblem& laws, const ContactModes& face,
                                               double accepted, const ForcesOfModes& forces_of);

}  // namespace rigor
