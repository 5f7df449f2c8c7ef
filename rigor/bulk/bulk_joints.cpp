#include "rigor/bulk/bulk_joints.hpp"

#include "rigor/core/assert.hpp"

namespace rigor {

// Scenes without joints only: `check_scheme` refuses the others.

struct BulkJoints::Rows {};

BulkJoints::BulkJoints(const Model& model) {
  RIGOR_ASSERT(model.joints().empty());
}

BulkJoints::~BulkJoints() = default;

void BulkJoints::prepare(const BulkBodies&, double, const std::vector<float>&, const Executor&) {}

void BulkJoints::warm_start(BulkBodies&, const Executor&) {}

void BulkJoints::solve(bool, BulkBodies&, const Executor&) {}

std::vector<float> BulkJoints::impulses() const {
  return {};
}

std::pair<double, int> BulkJoints::worst_error(const BulkBodies&) const {
  return {0, -1};
}

}  // namespace rigor
