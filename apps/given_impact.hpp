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
  std::array<std::string, 2> names;  ///< Of A and B.
  int number, count;                 ///< Which of how many contact points, from 1.
  ContactSystem system;              ///< The one contact and its bodies.
};

/// What `rigor impact` is asked about.
struct GivenImpact {
  Collision collision;
  std::optional<SceneContact> scene;
};

/// The impact of the options: K and u as numbers, or as two bodies of a scene have them where they touch.
/// Throws UsageError for values that make no sense, InputError for what the scene does not have.
GivenImpact read_given_impact(const ImpactOptions& options);

/// The text as a number of the range; "inf" is one where that is allowed. Throws UsageError.
double parse_number(const std::string& option, const std::string& text, double lowest, double highest,
                    bool may_be_infinite = false);

}  // namespace rigor
