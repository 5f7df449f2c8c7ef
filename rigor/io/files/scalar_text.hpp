#pragma once

#include "rigor/io/files/yaml_document.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// A number as written in a scene file: decimal, with a point and an exponent if necessary. The words for NaN
/// and infinity count as numbers too, so that the range check refuses them with its message.
struct NumberText {
  std::optional<double> value;
  std::string hint;  ///< Without a value: a hint such as "; write 1.5", or empty.
};
NumberText parse_number(std::string_view text);

/// The angle in rad of a text such as "30 deg" or "0.5 rad", or nothing.
std::optional<double> parse_angle(std::string_view text);

/// Whether a scalar is a text: in quotes, or neither a number nor true or false.
bool is_text(const YamlNode& scalar);

/// Description of a node for messages: "the text 'abc'", "a list of 2", "a mapping", "nothing".
std::string found_text(const YamlNode& node);

}  // namespace rigor
