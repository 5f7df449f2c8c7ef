#pragma once

#include "rigor/model/state.hpp"

namespace rigor {

/// Which face of a body is up, as a number from 1: of a box +x, -x, +y, -y, +z, -z; of a cylinder its ends +z
/// and -z, and 3 if it lies on its side; 0 if none is level to a degree. The axes are those of its one shape.
int face_up(const Model& model, const State& state, int body);

/// Whether face_up knows the faces of a body: one shape, a box or a cylinder.
bool has_faces(const Body& body);

}  // namespace rigor
