#pragma once

#include "rigor/bulk/state/vector_of.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/shape/shape.hpp"

namespace rigor {

/// A pair whose bodies move less against each other than this part of the thinner one's thickness is left to
/// its contacts.
constexpr double near_share = 0.5;
/// No pair that goes less than this part of it is examined.
constexpr double least_share = 0.05;
/// A pair is stopped where it overlaps by this part of it: it may go deeper by the springs of its contacts
/// before it is out of what an audit allows.
constexpr double deep_share = 0.15;
/// [rad], so that an arc is near to its chord.
constexpr double most_turn = 0.5;

/// Length of a vector of a MotionRecord.
inline double norm_of(const float* a) {
  return vector_of(a).norm();
}

/// Whether the narrow phase tells by the centre of what touches the shape on which side that is.
inline bool is_surface(const Shape& shape) {
  const Mesh* const mesh = std::get_if<Mesh>(&shape);
  return mesh != nullptr && mesh->tree->convex == nullptr;
}

}  // namespace rigor
