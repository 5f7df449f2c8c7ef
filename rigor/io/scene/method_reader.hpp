#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/run_settings.hpp"

namespace rigor {

/// The key `run` of a scene; defaults where it is absent.
RunSettings read_run(const ObjectReader& scene);

/// The key `method` of a scene; defaults where it is absent. Methods of later versions and combinations that
/// make no sense are told.
Method read_method(const ObjectReader& scene);

}  // namespace rigor
