#pragma once

#include "rigor/contact/time_of_impact.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/islands/cluster.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace rigor {

/// The way of the bodies along a step that was tried, where they move so far that its end alone does not say
/// what they met. In flight it is the closed form, with impulses the parabola that begins and ends as the
/// trial.
class TrialPath {
 public:
  using Pair = std::pair<int, int>;

  /// What moves, and where it was at the beginning: the boxes of all bodies there.
  struct Bodies {
    const Model& model;
    const Environment& environment;
    const std::vector<Aabb>& boxes;
  };
  /// From `start`, after the impacts at the beginning, to `end`, h > 0 later [s]; all arguments must outlive
  /// it.
  TrialPath(const Bodies& bodies, const ToiOptions& options, const Cluster& start, const Cluster& end,
            double h);

  /// When this pair, which does not touch at the beginning, meets, or h [s].
  double first_meeting(const Pair& pair);
  /// How long this pair goes no deeper into each other than `slack` [m] beyond what it overlaps at the
  /// beginning, or h [s].
  double without_overlap(const Pair& pair, double slack);
  /// Where the bodies of a pair are tau after the beginning [s].
  std::array<Pose, 2> poses(const Pair& pair, double tau);

 private:
  const Motion& motion(int body);
  double longest_arc(int body);
  double longest_arc(const Pair& pair);
  bool stays_apart(const Pair& pair);

  const Model& model_;
  const Environment& environment_;
  const std::vector<Aabb>& boxes_;
  const ToiOptions& options_;
  const Cluster &start_, &end_;
  double h_;
  std::vector<std::optional<Motion>> motions_;  ///< By body, made when they are asked for,
  std::vector<std::optional<double>> arcs_;     ///< and how long a parabola follows their turns [s].
};

}  // namespace rigor
