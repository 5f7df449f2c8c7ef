#pragma once

namespace rigor {

/// Whether a step is accepted, and the size of the next one.
struct StepDecision {
  bool is_accepted;
  double h_next;  ///< Next step size, after a rejection the one to try again with [s]; has the sign of h.
};

/// Proportional-integral control of the step size for a method with an error estimate,
///
///   h ← h clamp(0.9 err^(-0.7/p) err_old^(0.4/p), 0.2, 5),
///
/// err the estimate relative to the tolerance (≤ 1 is accepted), p the order. After a rejection h ← h
/// max(0.2, 0.9 err^(-1/p)), and the next accepted step does not grow. Of rejections in a row p is the order
/// with which the error really falls, at most the method's: where it is bounded by stability or a jump, its
/// own order would make it fall by little each time. reset() at every discontinuity (impact, contact change).
/// Sources: E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed. 1996, IV.2 (step
/// control of DOPRI5); K. Gustafsson, Control-Theoretic Techniques for Stepsize Selection in Implicit
/// Runge-Kutta Methods, ACM TOMS 20, 1994 (successive rejections).
class StepController {
 public:
  explicit StepController(int order) : order_(order) {}

  /// error: of the step of size h just tried; not finite counts as far too large.
  StepDecision decide(double h, double error);
  void reset() { *this = StepController(order_); }

 private:
  struct Rejection {
    double h, error;
  };
  double order_between(Rejection first, Rejection second) const;

  int order_;
  double old_error_ = 1;
  bool was_rejected_ = false;
  Rejection rejected_{0, 1};  ///< The last one, if was_rejected_.
};

}  // namespace rigor
