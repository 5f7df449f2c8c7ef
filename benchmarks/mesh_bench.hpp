#pragma once

#include "rigor/geometry/shape/triangle_mesh.hpp"
#include "rigor/math/pose.hpp"

#include <memory>

namespace rigor::bench {

/// Another library's tree of a mesh, and its queries of two.
class PeerMesh {
 public:
  virtual ~PeerMesh() = default;
  virtual double distance(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const = 0;
  virtual bool collides(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const = 0;
  virtual std::size_t count_pairs(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const = 0;
  virtual double bytes() const = 0;  ///< Of the tree alone.
};

#ifdef RIGOR_BENCH_FCL
/// Of the Flexible Collision Library: OBBRSS tree.
std::unique_ptr<PeerMesh> make_fcl_mesh(const TriangleMesh& mesh);
#endif

}  // namespace rigor::bench
