#pragma once

#include "rigor/contact/time_of_impact.hpp"
#include "rigor/core/index.hpp"
#include "rigor/dynamics/motion.hpp"
#include "rigor/geometry/broad_phase/broad_phase.hpp"
#include "rigor/sim/event_driven/event_queue.hpp"
#include "rigor/sim/witness/body_path.hpp"

#include <cstdint>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace rigor {

/// The present motion of every body, and for every pair that can meet the time at which it first does.
///
/// Each body is known to stay inside a box over its *window*, a span of time that depends on its motion
/// alone. Pairs whose boxes overlap are searched for their first contact over the common span of their
/// windows, nothing else; so an event costs what the bodies concerned cost. What is predicted depends only on
/// the two motions, never on when it was asked.
class Trajectories {
 public:
  Trajectories(const Model& model, const ToiOptions& options, BroadPhaseMethod method);

  /// Only bodies for which this holds meet each other from now on; the others have motions, but no windows.
  void follow_only(const std::vector<bool>& is_followed);
  /// From now on it is known where each body that is followed comes between t and t_end [s], in the windows
  /// that it has or in those that begin.
  void begin_ranges(double t, double t_end, bool has_windows);
  /// Where the body may have come, with the contact tolerance around it: two bodies whose ranges are apart
  /// have had nothing to do with each other. Of bounded bodies.
  const Aabb& range(int body) const { return ranges_[at(body)]; }

  const Motion& motion(int body) const { return tracks_[at(body)].motion; }
  /// Bodies whose motion changed at t: their old predictions are void; call predict() when all are set.
  void set_motion(int body, const Motion& motion, double t);
  /// Begins new windows at t for these bodies and queues the contacts and window ends that follow.
  void predict(const std::vector<int>& bodies, double t, EventQueue& queue);
  /// Windows as they are at t for bodies whose motions began earlier.
  void restore(const std::vector<int>& bodies, double t, EventQueue& queue);
  /// The contacts of these bodies with each other, in the windows that they have.
  void predict_among(const std::vector<int>& bodies, EventQueue& queue);
  /// Continues the search of a pair from where it stopped: until then it is proven free.
  void continue_search(const QueuedEvent& event, EventQueue& queue) {
    predict_pair(event.a, event.b, event.time, queue);
  }
  /// Whether the event was predicted from the present motions.
  bool is_current(const QueuedEvent& event) const;

  /// Pairs in lasting contact are watched by their island and not searched for impacts.
  void set_lasting_contact(int a, int b) { lasting_.insert(std::minmax(a, b)); }
  void clear_lasting_contacts(int body);
  bool has_lasting_contact(int a, int b) const { return lasting_.contains(std::minmax(a, b)); }
  /// Whether the body does not move at all.
  bool is_still(int body) const;

  /// Bodies that may be within the tolerance of this one at time t (which lies in its window), ascending.
  std::vector<int> neighbours(int body, double t, double tolerance) const;
  /// The paths of all bodies, followed since this call from t on.
  void begin_paths(double t);
  /// The paths from there to t, which are followed anew from t on.
  std::vector<BodyPath> take_paths(double t);
  /// How many pieces they have that are complete.
  std::size_t piece_count() const { return piece_count_; }
  /// Distance queries made so far.
  long distance_queries() const { return distance_queries_; }

 private:
  struct Track {
    Motion motion;
    double window_begin = 0, window_end = 0;
    Aabb box;  ///< Holds the body all through its window (bounded bodies).
    std::uint64_t version = 0;
    double followed = 0;  ///< From when on the motion is not in the path yet [s].
  };
  bool is_bounded(int body) const;
  double window_length(int body, double t) const;
  Aabb box_of(int body, double ta, double tb) const;
  void begin_window(int body, double t, EventQueue& queue);
  bool has_box(int body) const;
  double margin(int body, double t) const;
  void extend_range(int body);
  void predict_pairs(const std::vector<int>& bodies, EventQueue& queue);
  std::vector<int> candidates(int body) const;
  double window_end(int body, double t) const;
  void predict_pair(int a, int b, double from, EventQueue& queue);
  bool can_meet(int a, int b) const;

  const Model& model_;
  ToiOptions options_;
  std::vector<Track> tracks_;
  std::vector<double> turning_radii_;  ///< Of each body's shapes about its centre of mass [m].
  std::vector<int> unbounded_;         ///< Bodies with a plane.
  std::unique_ptr<BroadPhase> boxes_;  ///< Windows of the others.
  std::vector<bool> is_followed_;
  std::vector<Aabb> ranges_;  ///< Of each body, in this span [m]; empty if nobody asks for them.
  double ranges_begin_ = 0, ranges_end_ = 0;
  std::set<std::pair<int, int>> lasting_;
  std::vector<BodyPath> paths_;
  std::size_t piece_count_ = 0;
  long distance_queries_ = 0;
};

}  // namespace rigor
