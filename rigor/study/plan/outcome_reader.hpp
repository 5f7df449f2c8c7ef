#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/study/plan/study_plan.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rigor {

/// Reads outcome number `index`; mistakes are reported. names: of the parameters' numbers and of the outcomes
/// above, which formulas may use; scene quantities are checked where the scene is known.
Outcome read_outcome(const YamlNode& node, std::size_t index, const std::vector<std::string>& names,
                     SceneErrors& errors);

}  // namespace rigor
