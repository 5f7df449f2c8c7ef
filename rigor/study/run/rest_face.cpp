#include "rigor/study/run/rest_face.hpp"

#include "rigor/math/rotation.hpp"

#include <cmath>
#include <numbers>

namespace rigor {

bool has_faces(const Body& body) {
  return body.shapes.size() == 1 && (std::holds_alternative<Box>(body.shapes[0].shape) ||
                                     std::holds_alternative<Cylinder>(body.shapes[0].shape));
}

int face_up(const Model& model, const State& state, int body) {
  const double level = std::cos(std::numbers::pi / 180), upright = std::sin(std::numbers::pi / 180);
  const BodyShape& shape = model.body(body).shapes[0];
  // Heights of the tips of the shape's axes.
  const Vec3 up = (rotation_matrix(state.orientation(body)) * shape.X_BS.R).row(2).transpose();
  if (std::holds_alternative<Cylinder>(shape.shape)) {
    if (std::abs(up.z()) > level) return up.z() > 0 ? 1 : 2;
    return std::abs(up.z()) < upright ? 3 : 0;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(up[axis]) > level) return 2 * axis + (up[axis] > 0 ? 1 : 2);
  }
  return 0;
}

}  // namespace rigor
