#pragma once

#include <string>
#include <vector>

namespace rigor {

class Model;
struct Method;

/// What the scene asks for that the method's scheme cannot do, each message with the schemes that can; empty
/// if it can run the scene.
std::vector<std::string> check_scheme(const Model& model, const Method& method);

}  // namespace rigor
