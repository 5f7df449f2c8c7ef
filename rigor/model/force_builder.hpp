#pragma once

#include "rigor/model/body_table.hpp"
#include "rigor/model/model_builder.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigor {

/// The force with its bodies by index and its points and vector in the body frames B; nothing, and the reason
/// in the messages, if the description is invalid.
std::optional<Force> make_force(const ModelBuilder::ForceDescription& description, const std::string& where,
                                const BodyTable& bodies, std::vector<std::string>& messages);

}  // namespace rigor
