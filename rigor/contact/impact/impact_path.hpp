#pragma once

#include "rigor/contact/impact/tangential_compliance.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A point of an impact path and what the contact did on the stretch that leads to it (for the first point:
/// on the stretch that follows).
struct ImpactPathPoint {
  CollisionPoint at;
  bool is_compressing;
  bool is_sliding;
};

/// The labelled path of an impact from the points of resolve_collision, with the point of greatest
/// compression put in its place.
std::vector<ImpactPathPoint> impact_path_of(std::span<const CollisionPoint> path,
                                            const CollisionOutcome& outcome);
/// The same of an impact with compliance, where "sliding" is that of the surfaces, not of the bodies.
std::vector<ImpactPathPoint> impact_path_of(std::span<const CollisionPoint> path,
                                            const CompliantOutcome& outcome);

/// The phases of a compliant impact in the letters of CollisionOutcome::phases, and B for sliding against
/// u_t⁻.
std::string phase_letters(const CompliantOutcome& outcome);

/// "slides, greatest compression, slides, sticks to the end": the letters of CollisionOutcome::phases and
/// phase_letters in words, the first 24 of them.
std::string phases_in_words(std::string_view phases);

/// Largest over smallest eigenvalue of K; infinite where the smallest is not positive beyond rounding.
double condition_number(const Mat3& K);

/// ½ uᵀ K⁻¹ u: the most kinetic energy that an impulse at the contact can take [J]; infinite where K is
/// singular beyond rounding.
double removable_energy(const Mat3& K, const Vec3& u);

}  // namespace rigor
