#pragma once

#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// The name of a convex part of a shape: the whole shape, the box of a node of a mesh's tree (standing for
/// all that it holds), or a triangle.
struct PartName {
  enum class Kind { whole, node, triangle };
  Kind kind = Kind::whole;
  int index = 0;

  bool is_node() const { return kind == Kind::node; }
};

/// The part with which a search over the shape begins. Against a half-space a mesh behaves like its hull, so
/// it is a single part.
PartName first_part(const Shape& shape, bool against_unbounded);
/// The parts into which a node is split: its children, or the triangles of a leaf.
std::vector<PartName> parts_of_node(const Mesh& mesh, int node);

/// A part on its moving body. It can be neither copied nor moved, because its core refers to its own corners.
class MovingPart {
 public:
  /// `sample`, if at hand, is the sample of the motion at the time of interest; it must outlive this object.
  MovingPart(const MovingShape& moving, const PartName& name, const RigidMotion::Sample* sample = nullptr);
  MovingPart(const MovingPart&) = delete;
  MovingPart& operator=(const MovingPart&) = delete;

  const MovingCore& core() const { return core_; }
  double size() const { return 2 * core_.core.extent; }  ///< Approximate diameter [m].

 private:
  MovingCore core_;
  std::array<Vec3, 3> corners_;
};

}  // namespace rigor
