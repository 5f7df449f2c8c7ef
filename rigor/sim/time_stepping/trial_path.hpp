#pragma once

#include "rigor/contact/time_of_impact.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/islands/cluster.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace rigor {

/// The way of the bodies along a step that was tried, where they move so far that its end alone does not say
/// what they met. In flight it is the closed form, with impulses the parabola that begins and ends as the
/// trial.
class TrialPath {
 public:
  using Pair = std::pair<int, int>;

  /// From `start`, after the impacts at the beginning, to `end`, h > 0 later [s]; all arguments must outlive
  /// it.
  TrialPath(const Model& model, const Environment& environment, const ToiOptions& options,
            const Cluster& start, const Cluster& end, double h);

  /// When the first of these pairs, which do not touch at the beginning, meets, or h [s].
  double first_meeting(std::span<const Pair> pairs);
  /// How long these pairs, which touch at the beginning, go no deeper into each other than a share of their
  /// thickness (one of each body [m]), or h [s].
  double without_overlap(std::span<const Pair> pairs, std::span<const double> thickness);

 private:
  const Motion& motion(int body);
  double longest_arc(Pair pair);
  double without_overlap(Pair pair, double slack, double span);

  const Model& model_;
  const Environment& environment_;
  const ToiOptions& options_;
  const Cluster &start_, &end_;
  double h_;
  std::vector<std::optional<Motion>> motions_;  ///< By body, made when they are asked for.
};

}  // namespace rigor
