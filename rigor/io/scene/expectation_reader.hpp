#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/io/scene/scene_reader.hpp"

#include <vector>

namespace rigor {

/// The places where the scene expects its bodies. Whether the bodies exist is checked later.
std::vector<ExpectedPlace> read_expectations(const ObjectReader& scene);

/// Reports names that are not those of dynamic bodies.
void check_expectations(const ObjectReader& scene, const std::vector<ExpectedPlace>& expected,
                        const Model& model);

}  // namespace rigor
