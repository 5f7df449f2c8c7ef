#include "mesh_bench.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

namespace rigor::bench {
namespace {

fcl::Transform3d transform(const Pose& X) {
  fcl::Transform3d T = fcl::Transform3d::Identity();
  T.linear() = X.R;
  T.translation() = X.p;
  return T;
}

class FclMesh : public PeerMesh {
 public:
  using Tree = fcl::BVHModel<fcl::OBBRSSd>;

  explicit FclMesh(const TriangleMesh& mesh) {
    std::vector<fcl::Triangle> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
      triangles.emplace_back(static_cast<std::size_t>(a), static_cast<std::size_t>(b),
                             static_cast<std::size_t>(c));
    }
    tree_ = std::make_shared<Tree>();
    tree_->beginModel();
    tree_->addSubModel(mesh.vertices, triangles);
    tree_->endModel();
  }

  double distance(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const override {
    fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    return fcl::distance(tree_.get(), transform(X_WA), of(b), transform(X_WB), request, result);
  }
  bool collides(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const override {
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(tree_.get(), transform(X_WA), of(b), transform(X_WB), request, result) > 0;
  }
  std::size_t count_pairs(const Pose& X_WA, const PeerMesh& b, const Pose& X_WB) const override {
    fcl::CollisionRequestd request(10000000);
    fcl::CollisionResultd result;
    return fcl::collide(tree_.get(), transform(X_WA), of(b), transform(X_WB), request, result);
  }
  double bytes() const override {
    return static_cast<double>(tree_->getNumBVs()) * static_cast<double>(sizeof(fcl::BVNode<fcl::OBBRSSd>));
  }

 private:
  static const Tree* of(const PeerMesh& mesh) { return dynamic_cast<const FclMesh&>(mesh).tree_.get(); }

  std::shared_ptr<Tree> tree_;
};

}  // namespace

std::unique_ptr<PeerMesh> make_fcl_mesh(const TriangleMesh& mesh) {
  return std::make_unique<FclMesh>(mesh);
}

}  // namespace rigor::bench
