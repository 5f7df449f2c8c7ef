#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/study/plan/study_plan.hpp"

#include <cstddef>
#include <vector>

namespace rigor {

/// Reads parameter number `index`; mistakes are reported.
Parameter read_parameter(const YamlNode& node, std::size_t index, SceneErrors& errors);

/// Reports a name that is no name of formulas: it begins with a letter and has letters, digits and _.
void check_formula_name(const ObjectReader& object, const std::string& name);

/// The texts of a list, or of a text alone; mistakes are reported.
std::vector<std::string> read_texts(const ObjectReader& object, const char* key);

/// Reports a formula that is wrong, or that uses a name that is not among these.
void check_formula(const ObjectReader& object, const char* key, const std::string& formula,
                   const std::vector<std::string>& names);

}  // namespace rigor
