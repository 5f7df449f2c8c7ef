#include "rigor/geometry/decomposition/lipschitz_maximum.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

namespace rigor {
namespace {

struct BoundedBox {
  Aabb box;
  double upper;
  int number;  ///< Older first among equals.
};

struct IsLater {
  bool operator()(const BoundedBox& a, const BoundedBox& b) const {
    return a.upper != b.upper ? a.upper < b.upper : a.number > b.number;
  }
};

class Search {
 public:
  Search(const LipschitzFunction& function, const MaximumGoal& goal) : function_(function), goal_(goal) {
    result_.place = 0.5 * (function.box.lower + function.box.upper);
  }

  MaximumBounds run() {
    // Good points first raise the lower bound, so that fewer boxes have to be halved.
    for (const Vec3& p : function_.starts) {
      if (function_.beyond(p) <= 0) take(p, function_.value(p));
    }
    add(function_.box, std::numeric_limits<double>::infinity());
    while (!boxes_.empty()) {
      // The box with the largest bound limits the maximum everywhere. The search ends when that bound is
      // close enough to the best value.
      const BoundedBox top = boxes_.top();
      result_.upper = std::max(top.upper, result_.lower);
      const double gap = std::max(goal_.relative_gap * result_.lower, goal_.absolute_gap);
      if (result_.upper <= std::max(result_.lower + gap, goal_.enough)) return result_;
      if (evaluations_ >= goal_.max_evaluations) return result_;
      boxes_.pop();
      halve(top);
    }
    result_.upper = result_.lower;
    return result_;
  }

 private:
  void take(const Vec3& p, double value) {
    if (!(value > result_.lower)) return;
    result_.lower = value;
    result_.place = p;
  }

  void halve(const BoundedBox& parent) {
    int axis = 0;
    (parent.box.upper - parent.box.lower).maxCoeff(&axis);
    const double middle = 0.5 * (parent.box.lower[axis] + parent.box.upper[axis]);
    Aabb low = parent.box, high = parent.box;
    low.upper[axis] = high.lower[axis] = middle;
    add(low, parent.upper);
    add(high, parent.upper);
  }

  void add(const Aabb& box, double parent_upper) {
    // No point of the box is farther from its centre than its half diagonal, and the value changes by no more
    // than that.
    const Vec3 center = 0.5 * (box.lower + box.upper);
    const double radius = 0.5 * (box.upper - box.lower).norm();
    const double beyond = function_.beyond(center);
    if (beyond > radius) return;
    ++evaluations_;
    const double value = function_.value(center);
    if (beyond <= 0) take(center, value);
    const double upper = std::min(value + radius, parent_upper);
    if (upper > result_.lower) boxes_.push({box, upper, evaluations_});
  }

  const LipschitzFunction& function_;
  const MaximumGoal& goal_;
  MaximumBounds result_;
  int evaluations_ = 0;
  std::priority_queue<BoundedBox, std::vector<BoundedBox>, IsLater> boxes_;
};

}  // namespace

MaximumBounds lipschitz_maximum(const LipschitzFunction& function, const MaximumGoal& goal) {
  return Search(function, goal).run();
}

}  // namespace rigor
