#pragma once

#include "rigor/io/scene/object_reader.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/method/run_settings.hpp"

namespace rigor {

/// Reads the key `run` of a scene; defaults apply where it is absent.
RunSettings read_run(const ObjectReader& scene);

/// Reads the key `method` of a scene; defaults apply where it is absent. Methods of later versions and
/// invalid combinations are reported.
Method read_method(const ObjectReader& scene);

}  // namespace rigor
