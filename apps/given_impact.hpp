#pragma once

#include "apps/options.hpp"
#include "rigor/contact/impact/collision.hpp"
#include "rigor/contact/system/contact_system.hpp"

#include <array>
#include <optional>
#include <string>

namespace rigor {

/// A contact of two bodies of a scene, at t = 0.
struct SceneContact {
  std::array<std::string, 2> names;  ///< Names of A and B.
  int number, count;                 ///< Number of the contact point, counted from 1, and of all of them.
  ContactSystem system;              ///< The one contact and its bodies.
};

/// The impact that `rigor impact` examines.
struct GivenImpact {
  Collision collision;
  std::optional<SceneContact> scene;
};

/// The impact that the options give: K and u as numbers, or as those of two bodies of a scene where they
/// touch. Throws UsageError for invalid values, InputError for things that the scene does not have.
GivenImpact read_given_impact(const ImpactOptions& options);

/// The text as a number in the range; "inf" counts as one where that is allowed. Throws UsageError.
double parse_number(const std::string& option, const std::string& text, double lowest, double highest,
                    bool may_be_infinite = false);

}  // namespace rigor
