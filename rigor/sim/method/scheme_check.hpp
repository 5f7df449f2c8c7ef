#pragma once

#include "rigor/model/model.hpp"
#include "rigor/sim/method/method.hpp"

#include <string>
#include <vector>

namespace rigor {

/// What of the scene the method's scheme cannot do, each message with the schemes that can; empty if nothing.
std::vector<std::string> check_scheme(const Model& model, const Method& method);

}  // namespace rigor
