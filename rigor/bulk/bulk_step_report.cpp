#include "rigor/bulk/bulk_step_report.hpp"

#include "rigor/core/index.hpp"

#include <algorithm>

namespace rigor {

void BulkStepReport::add(const BulkStepReport& later) {
  parts += later.parts;
  pair_count = later.pair_count, manifold_count = later.manifold_count, point_count = later.point_count;
  direct_islands = later.direct_islands, sleeping_count = later.sleeping_count;
  impacts.insert(impacts.end(), later.impacts.begin(), later.impacts.end());
  momentum_error += later.momentum_error;
  rounded_momentum += later.rounded_momentum;
  work += later.work;
  if (later.max_overlap > max_overlap) {
    max_overlap = later.max_overlap;
    overlap_A = later.overlap_A, overlap_B = later.overlap_B;
  }
  if (later.worst_share > worst_share) {
    worst_share = later.worst_share, worst_overlap = later.worst_overlap;
    worst_A = later.worst_A, worst_B = later.worst_B;
  }
  if (later.max_joint_error > max_joint_error) {
    max_joint_error = later.max_joint_error;
    worst_joint = later.worst_joint;
  }
  if (broken_body < 0) broken_body = later.broken_body;
}

BulkStepReport describe_contacts(const Model& model, const std::vector<ShapePair>& pairs,
                                 const ManifoldList& manifolds) {
  BulkStepReport report;
  report.pair_count = static_cast<int>(pairs.size());
  report.manifold_count = static_cast<int>(manifolds.size());
  for (std::size_t k = 0; k < manifolds.size(); ++k) {
    report.point_count += manifolds.point_count(k);
    double deepest = 0;
    for (int i = 0; i < manifolds.point_count(k); ++i)
      deepest = std::max(deepest, -double{manifolds.view(k).points[i].gap});
    if (deepest <= 0) continue;

    // The deepest of all points counts, the first of equal ones.
    const ShapePair& pair = pairs[at(manifolds.pair(k))];
    if (deepest > report.max_overlap) {
      report.max_overlap = deepest;
      report.overlap_A = pair.body_A;
      report.overlap_B = pair.body_B;
    }
    // So does the largest share of the thinner body.
    const double thickness = std::min(model.body(pair.body_A).thickness, model.body(pair.body_B).thickness);
    if (deepest > report.worst_share * thickness) {
      report.worst_share = deepest / thickness;
      report.worst_overlap = deepest;
      report.worst_A = pair.body_A;
      report.worst_B = pair.body_B;
    }
  }
  return report;
}

}  // namespace rigor
