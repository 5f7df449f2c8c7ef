#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/model/time_function.hpp"

#include <optional>
#include <string_view>

namespace rigor {

/// The value of a key of type `function`; nothing if it is absent or wrong, which is reported.
std::optional<TimeFunction> read_time_function(const ObjectReader& object, std::string_view key);

}  // namespace rigor
