#pragma once

#include "rigor/model/model.hpp"

#include <vector>

namespace rigor {

/// Dynamic bodies that may touch any other body, ascending.
std::vector<int> colliding_bodies(const Model& model);

}  // namespace rigor
