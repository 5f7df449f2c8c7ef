#include "rigor/study/kinds/strategy.hpp"

namespace rigor {

std::unique_ptr<Strategy> make_strategy(const StudyPlan& plan) {
  switch (plan.kind) {
    case StudyKind::sweep:
    case StudyKind::chaos:
      return make_sweep(plan);
    case StudyKind::monte_carlo:
      return make_monte_carlo(plan);
    case StudyKind::bisection:
      return make_bisection(plan);
    case StudyKind::sensitivity:
      return make_sensitivity(plan);
    case StudyKind::morris:
      return make_morris(plan);
    case StudyKind::minimise:
    case StudyKind::maximise:
      return make_optimum(plan);
  }
  return nullptr;
}

}  // namespace rigor
