#include "rigor/geometry/motion/time_of_contact.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/geometry/convex/convex_distance.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"
#include "rigor/geometry/motion/cavity_step.hpp"
#include "rigor/geometry/motion/moving_part.hpp"
#include "rigor/geometry/shape/containment.hpp"
#include "rigor/geometry/shape/support.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

namespace rigor {
namespace {

/// Two parts that are proven apart until `time`.
struct PartPair {
  double time;
  long order;  ///< Breaks ties between equal times.
  int shape_A, shape_B;
  PartName a, b;

  bool operator>(const PartPair& other) const {
    return time != other.time ? time > other.time : order > other.order;
  }
};

bool is_unbounded(const MovingShape& moving) {
  return is_unbounded(*moving.shape);
}
bool is_cavity(const MovingShape& moving) {
  return std::holds_alternative<Cavity>(*moving.shape);
}

/// The distance of a pair of parts at one instant, with its rate.
struct Approach {
  DistanceResult distance;
  double rate = 0;   ///< [m/s], negative when approaching.
  double touch = 0;  ///< Distances up to this cannot be told from contact [m].
};

/// The best-first search. Its queue holds the pairs of parts that are not yet proven free until the end.
class Search {
 public:
  Search(std::span<const MovingShape> A, std::span<const MovingShape> B, double end,
         const TimeOfContactOptions& options)
      : A_(A), B_(B), end_(end), options_(options) {
    result_.lower = result_.upper = end;
  }

  TimeOfContact find(double t0) {
    // Every pair of shapes begins as one pair of parts, free until t0.
    for (int a = 0; a < static_cast<int>(A_.size()); ++a) {
      for (int b = 0; b < static_cast<int>(B_.size()); ++b) begin(t0, a, b);
    }
    // The pair with the least time goes first: whatever touches there does so before any other pair can.
    while (!queue_.empty() && !result_.is_contact) {
      poll_interrupt();
      const PartPair next = queue_.top();
      queue_.pop();
      if (result_.evaluations >= options_.most_evaluations) return given_up(next.time);
      advance(next);
    }
    return result_;
  }

 private:
  const MovingShape& A(const PartPair& pair) const { return A_[at(pair.shape_A)]; }
  const MovingShape& B(const PartPair& pair) const { return B_[at(pair.shape_B)]; }

  /// Puts a pair of shapes into the queue, and looks once for a solid that encloses the other shape.
  void begin(double t0, int a, int b) {
    PartPair pair{t0, 0, a, b, {}, {}};
    RIGOR_ASSERT(!is_unbounded(A(pair)) || !is_unbounded(B(pair)));
    pair.a = first_part(*A(pair).shape, is_unbounded(B(pair)));
    pair.b = first_part(*B(pair).shape, is_unbounded(A(pair)));
    const bool is_inside = holds_a_point_of(A(pair), B(pair), t0) || holds_a_point_of(B(pair), A(pair), t0);
    if (is_inside && !result_.is_contact) {
      // A surface inside a closed mesh overlaps its solid without touching its triangles. This is examined at
      // t0 only: later a shape could get inside only through the surface.
      accept(pair, t0, t0,
             Approach{.distance =
                          DistanceResult{0, 0, 0, A(pair).pose(t0).p, A(pair).pose(t0).p, Vec3::UnitZ()}});
    }
    push(pair);
  }

  /// Whether the solid of a closed mesh contains one point of the other shape (and hence all of it, unless
  /// the surfaces meet).
  static bool holds_a_point_of(const MovingShape& mesh, const MovingShape& other, double t) {
    const Mesh* of = std::get_if<Mesh>(mesh.shape);
    if (of == nullptr || !of->tree->is_closed || is_unbounded(other)) return false;
    const Vec3 p_W = other.pose(t) * support_point(*other.shape, Vec3::UnitZ());
    return contains(*mesh.shape, mesh.pose(t).inverse() * p_W);
  }

  void push(PartPair pair) {
    pair.order = ++pushed_;
    queue_.push(pair);
  }

  /// The signed distance of two parts at time t, with its rate and the distance that rounding blurs.
  Approach approach(const PartPair& pair, const MovingPart& a, const MovingPart& b, double t) {
    ++result_.evaluations;
    const RigidMotion::Sample in_A = A(pair).motion->sample(t), in_B = B(pair).motion->sample(t);
    Approach now;
    if (is_unbounded(A(pair)) || is_unbounded(B(pair))) {
      now.distance =
          signed_distance(*A(pair).shape, in_A.X_WB * A(pair).X_BS, *B(pair).shape, in_B.X_WB * B(pair).X_BS);
    } else {
      now.distance =
          convex_distance(a.core().core, in_A.X_WB * a.core().X_BC, b.core().core, in_B.X_WB * b.core().X_BC);
    }
    // The rate of the gap is the relative velocity along the normal at the midpoint of the witness points.
    const Vec3 p_W = 0.5 * (now.distance.p_WA + now.distance.p_WB);
    now.rate = now.distance.n_W.dot(in_B.velocity_at(p_W) - in_A.velocity_at(p_W));
    // A few tens of roundings of sizes and coordinates cannot be told from contact.
    now.touch = 32 * kEpsilon *
                (a.size() + b.size() + in_A.X_WB.p.cwiseAbs().maxCoeff() + in_B.X_WB.p.cwiseAbs().maxCoeff());
    return now;
  }

  /// One step of conservative advancement for one pair: ends the search with a contact, drops the pair if it
  /// is free until the end, or puts it (or its children) back into the queue with a later time.
  void advance(const PartPair& pair) {
    const MovingPart a(A(pair), pair.a), b(B(pair), pair.b);
    const Approach now = approach(pair, a, b, pair.time);
    const bool is_whole = !pair.a.is_node() && !pair.b.is_node();
    const double finest = 4 * kEpsilon * std::abs(pair.time);
    const double width = std::max(options_.time_tolerance, finest);
    if (is_whole && now.distance.distance <= now.touch) {
      // Contact. In exact arithmetic it may come later than this time, by as much as the shapes take to pass
      // the distance that rounding blurs.
      const double later = now.rate < 0 ? std::min(width, 2 * now.touch / -now.rate) : 0;
      accept(pair, pair.time, pair.time + later, now);
      return;
    }
    // Once the contact is expected within half the width that the bracket may have, its upper end is looked
    // for directly.
    if (is_whole && meets_within(pair, a, b, now, width)) return;

    // The step that SeparationBound (or the bound for a cavity) proves free, from the certified lower bound
    // of the distance. There is none where the boxes of the parts overlap.
    const double gap = std::min(now.distance.lower, now.distance.distance);
    double step = 0;
    if (gap > 0 && (is_cavity(A(pair)) || is_cavity(B(pair)))) {
      const bool is_A = is_cavity(A(pair));
      step = safe_step_in_cavity(is_A ? A(pair) : B(pair), is_A ? B(pair) : A(pair), pair.time, end_, 0);
    } else if (gap > 0) {
      const SeparationBound bound(a.core(), b.core(), now.distance.n_W, gap, pair.time, end_);
      step = bound.safe_step(end_ - pair.time, 0);
    }
    // A pair that is free until the end of the span is forgotten.
    if (step >= end_ - pair.time) return;
    // A pair with a box is replaced by the pairs of its children: they lie inside it, so they are free until
    // the same time.
    PartPair next = pair;
    if (!is_whole) {
      next.time += step;
      split(next, a.size(), b.size());
      return;
    }
    // A pair of convex parts continues itself, by no less than the resolution of time so that the search
    // always proceeds.
    next.time = std::min(end_, pair.time + std::max(step, finest));
    push(next);
  }

  /// Whether the pair touches one allowed bracket width later; if so, that is the contact and the search
  /// ends.
  bool meets_within(const PartPair& pair, const MovingPart& a, const MovingPart& b, const Approach& now,
                    double width) {
    if (!(now.rate < 0) || now.distance.distance > 0.5 * width * -now.rate) return false;
    const double later = std::min(end_, pair.time + width);
    const Approach then = approach(pair, a, b, later);
    if (then.distance.distance > then.touch) return false;
    accept(pair, pair.time, later, then);
    return true;
  }

  /// Replaces a pair by the pairs of the children of its larger box, which keeps the two parts of a pair of
  /// similar size.
  void split(const PartPair& pair, double size_a, double size_b) {
    const bool cuts_a = pair.a.is_node() && (!pair.b.is_node() || size_a >= size_b);
    const Mesh& mesh = *std::get_if<Mesh>(cuts_a ? A(pair).shape : B(pair).shape);
    for (const PartName& part : parts_of_node(mesh, cuts_a ? pair.a.index : pair.b.index)) {
      PartPair next = pair;
      (cuts_a ? next.a : next.b) = part;
      push(next);
    }
  }

  void accept(const PartPair& pair, double lower, double upper, const Approach& at_upper) {
    result_.is_contact = true;
    result_.lower = lower;
    result_.upper = upper;
    result_.distance = at_upper.distance;
    result_.shape_A = pair.shape_A;
    result_.shape_B = pair.shape_B;
  }

  TimeOfContact given_up(double t) {
    result_.is_complete = false;
    result_.lower = t;
    return result_;
  }

  std::span<const MovingShape> A_, B_;
  double end_;
  TimeOfContactOptions options_;
  std::priority_queue<PartPair, std::vector<PartPair>, std::greater<>> queue_;
  long pushed_ = 0;
  TimeOfContact result_;
};

}  // namespace

TimeOfContact find_time_of_contact(std::span<const MovingShape> A, std::span<const MovingShape> B, double t0,
                                   double t1, const TimeOfContactOptions& options) {
  RIGOR_ASSERT(t0 <= t1 && std::isfinite(t1));
  return Search(A, B, t1, options).find(t0);
}

TimeOfContact find_time_of_contact(const MovingShape& A, const MovingShape& B, double t0, double t1,
                                   const TimeOfContactOptions& options) {
  return find_time_of_contact(std::span(&A, 1), std::span(&B, 1), t0, t1, options);
}

}  // namespace rigor
