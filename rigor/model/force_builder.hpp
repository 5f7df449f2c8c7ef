#pragma once

#include "rigor/model/model_builder.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The bodies of a scene, built, with their names.
struct BodyTable {
  const std::vector<Body>& bodies;
  const std::map<std::string, int>& index;
};

/// Message about a body that does not exist: "unknown body 'bal'; did you mean 'ball'?".
std::string unknown_body(const std::string& name, const BodyTable& bodies);

/// The force with its bodies by index and its points and vector in the body frames B; nothing, and why in the
/// messages, if it makes no sense.
std::optional<Force> make_force(const ModelBuilder::ForceDescription& description, const std::string& where,
                                const BodyTable& bodies, std::vector<std::string>& messages);

}  // namespace rigor
