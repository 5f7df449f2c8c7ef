#pragma once

#include "rigor/sim/method/method.hpp"

#include <string_view>

namespace rigor {

/// Whether the method's scheme looks at this choice; another value of one that it does not look at changes
/// nothing in a motion. Every scheme looks at a choice that is not in the table, and `auto`, of which nothing
/// is known yet, at all.
bool uses_choice(const Method& method, std::string_view key);

}  // namespace rigor
