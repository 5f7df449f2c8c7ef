#pragma once

#include "rigor/geometry/motion/separation_bound.hpp"
#include "rigor/geometry/motion/time_of_contact.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rigor {

/// A convex part of a shape, by its name: the whole shape, what the box of a node of a mesh's tree holds, or
/// a triangle.
struct PartName {
  enum class Kind { whole, node, triangle };
  Kind kind = Kind::whole;
  int index = 0;

  bool is_node() const { return kind == Kind::node; }
};

/// The part that a search over the shape begins with. Against a half-space a mesh is as its hull: one part.
PartName first_part(const Shape& shape, bool against_unbounded);
/// The parts that a node is made of.
std::vector<PartName> parts_of_node(const Mesh& mesh, int node);

/// A part on its moving body. Stays where it is made: its core refers to it.
class MovingPart {
 public:
  /// `sample` is of the motion at the time of interest, if at hand; it must outlive this.
  MovingPart(const MovingShape& moving, const PartName& name, const RigidMotion::Sample* sample = nullptr);
  MovingPart(const MovingPart&) = delete;
  MovingPart& operator=(const MovingPart&) = delete;

  const MovingCore& core() const { return core_; }
  double size() const { return 2 * core_.core.extent; }  ///< About its diameter [m].

 private:
  MovingCore core_;
  std::array<Vec3, 3> corners_;
};

}  // namespace rigor
