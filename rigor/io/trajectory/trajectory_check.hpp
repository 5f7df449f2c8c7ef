#pragma once

#include "rigor/io/trajectory/hdf5_reader.hpp"

#include <string>

namespace rigor {

/// Why a stored trajectory cannot be of a run, "an orientation in row 3 is not a unit quaternion", or an
/// empty text. Every number must be finite (forces of joints may be missing), times must not go back, events
/// must name bodies that exist and kinds that there are.
std::string trajectory_error(const StoredTrajectory& stored);

}  // namespace rigor
