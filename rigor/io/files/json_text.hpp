#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace rigor {

/// JSON text of a value: indented by two spaces, lists of numbers on one line, numbers with 17 significant
/// digits (integers as they are), infinite and NaN numbers as null, bytes that are not UTF-8 replaced.
std::string json_text(const nlohmann::ordered_json& value);
/// The same on one line.
std::string json_line(const nlohmann::ordered_json& value);

}  // namespace rigor
