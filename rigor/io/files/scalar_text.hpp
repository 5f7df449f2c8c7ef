#pragma once

#include "rigor/io/files/yaml_document.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace rigor {

/// A number as the scene file writes it: decimal, with a point and an exponent if need be. Words for NaN and
/// infinity are numbers too, for the range check to refuse with its message.
struct NumberText {
  std::optional<double> value;
  std::string hint;  ///< Without a value: what may help, "; write 1.5" or empty.
};
NumberText parse_number(std::string_view text);

/// Angle in rad of "30 deg" or "0.5 rad", or nothing.
std::optional<double> parse_angle(std::string_view text);

/// Whether a scalar is a text: in quotes, or neither a number nor true or false.
bool is_text(const YamlNode& scalar);

/// What a node is, for messages: "the text 'abc'", "a list of 2", "a mapping", "nothing".
std::string found_text(const YamlNode& node);

}  // namespace rigor
