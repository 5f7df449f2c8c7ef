#pragma once

#include "rigor/io/files/yaml_document.hpp"

#include <string>

namespace rigor {

/// A value of a document on one line, as it may stand behind `--set KEY=`: "[0, 0, 1.5]", "{step: 0.01}".
/// Read again it is the same value.
std::string flow_text(const YamlNode& node);

}  // namespace rigor
