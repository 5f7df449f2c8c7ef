#pragma once

#include <string_view>

namespace rigor {

struct Method;

/// Whether the method's scheme reads this choice: the value of a choice that it does not read changes nothing
/// in a motion. Every scheme reads the choices that are not in the table; `auto`, which may stand for any
/// scheme, reads all of them.
bool uses_choice(const Method& method, std::string_view key);

}  // namespace rigor
