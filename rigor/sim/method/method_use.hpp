#pragma once

#include <string_view>

namespace rigor {

struct Method;

/// Whether the method's scheme, with its solver, reads this choice: the value of a choice that it does not
/// read changes nothing in a motion. `auto`, which may stand for any scheme, reads all of them.
bool uses_choice(const Method& method, std::string_view key);

}  // namespace rigor
