#include "rigor/solver/coulomb/proximal_points.hpp"

#include "rigor/core/interrupt.hpp"
#include "rigor/solver/coulomb/coulomb_law.hpp"
#include "rigor/solver/coulomb/interior_point.hpp"
#include "rigor/solver/coulomb/proximal_point.hpp"
#include "rigor/solver/coulomb/proximal_point_by_forces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rigor {

using Eigen::Index;

namespace {

// Times 1 / the mean diagonal of a contact's block. Longer steps multiply the rounding of the motion into the
// forces.
constexpr double kFirstRho = 10;
constexpr double kLargestPointRho = 1e4;
constexpr double kGrowth = 10;
// With forces as unknowns a point begins where the last one ended, and the first may be as near as this.
constexpr double kBoldRho = 1e3;
// Points that begin near the solution may be as near as this.
constexpr double kRhoNear = 1e4;
// Where those from inside the cones end unsolved, nearer ones often do not.
constexpr double kSecondRhoInside = 1e2;
// Where points come no nearer than by this share, contacts jam: forces that do nothing have to grow far
// before they show whether the contacts contradict each other. Longer steps get there sooner, and their
// rounding is still below what counts as solved.
constexpr double kSlow = 0.3;
constexpr double kLargestSlowRho = 1e6;
// In bold searches points need not be exact while they come nearer; where they do not, what is left may be a
// contradiction, which shows only in points that solve their own law. At events all are exact: of the forces
// that solve a problem equally well, rough points find others than exact ones, and a row of dominoes then
// moves sideways and chatters.
constexpr double kRoughShare = 0.1;
constexpr double kExactShare = 1e-3;

/// Whether a search begins with what an interior point method finds.
bool begins_inside(const CoulombProblem& laws, const ProximalPointOptions& options) {
  return options.is_bold && options.start.size() == 0 && laws.mu.size() >= kFewestInside;
}

class ProximalPoints {
 public:
  ProximalPoints(const CoulombProblem& laws, const ContactMotion& motion,
                 const std::function<double(const VecX&)>& size_of, const ProximalPointOptions& options,
                 double rho_inside = kRhoNear)
      : laws_(laws),
        motion_(motion),
        size_of_(size_of),
        options_(options),
        masses_(effective_masses(motion.diagonal())),
        rho_(options.is_bold ? kBoldRho : kFirstRho),
        is_bold_(options.is_bold) {
    const Index count = static_cast<Index>(laws.mu.size());
    from_.lambda = options.start.size() > 0 ? clamp_to_cones(laws, options.start) : VecX::Zero(3 * count);
    if (begins_inside(laws, options)) begin_inside(rho_inside);
    if (options.is_near) rho_ = kRhoNear;
    from_.complete(motion_);
  }

  std::optional<CoulombSolution> run() {
    constexpr int kMaxPoints = 60, kPatience = 3;
    double growth = kGrowth;
    int stalls = 0, failures = 0;
    bool is_slow = false;
    for (int point = 1; point <= kMaxPoints; ++point) {
      poll_interrupt();
      const std::optional<ProximalPoint> next =
          next_point(options_.is_bold && !is_slow ? kRoughShare : kExactShare);
      if (next) {
        // How well its forces solve the law with b, and with the b' that the point has.
        Candidate candidate = candidate_of(*next);
        is_slow = !(candidate.residual < std::max(kSlow * least(), options_.enough));
        stalls = candidate.residual < 0.5 * least() ? 0 : stalls + 1;
        failures = 0;
        keep(std::move(candidate), point);
        if (best_ && best_->residual <= options_.wanted) return solution_of(*best_, best_->residual);

        // The next point, with a longer step; where rounding held this one back, with a shorter one.
        from_.lambda = next->lambda;
        from_.complete(motion_);
        const double largest = is_slow ? kLargestSlowRho : kLargestPointRho;
        if (next->is_rounded)
          rho_ = std::max(rho_ / growth, kFirstRho);
        else if (rho_ < largest)
          rho_ = std::min(growth * rho_, largest);
      } else if (is_bold_) {
        // Contacts go to and fro between modes: nearer points, by the motion alone.
        is_bold_ = false;
        rho_ = std::min(rho_, kFirstRho);
      } else {
        // Too far for Newton's method: nearer points, and smaller steps from then on.
        ++failures;
        rho_ /= growth * growth;
        growth = std::max(1.5, std::sqrt(growth));
      }

      // The search ends when it gets no farther from what counts as solved.
      if (stalls + failures > 0 && best_ && best_->residual <= options_.enough)
        return solution_of(*best_, best_->residual);
      if (stalls >= kPatience && nearest_) return solution_of(*nearest_, nearest_->changed_residual);
    }
    if (!options_.gives_best || !best_) return std::nullopt;
    return solution_of(*best_, best_->residual);
  }

 private:
  void begin_inside(double rho) {
    const std::optional<VecX> inside = interior_forces(laws_, motion_);
    if (!inside) return;
    from_.lambda = clamp_to_cones(laws_, *inside);
    rho_ = rho;
  }

  std::optional<ProximalPoint> next_point(double share) {
    const ProximalStart start{laws_, motion_, masses_, from_, rho_, share};
    return is_bold_ ? by_forces_.find(start) : proximal_point_by_motion(start);
  }

  /// Forces as an answer to the problem.
  struct Candidate {
    VecX lambda, w;
    std::vector<ContactMode> modes;
    double residual;          ///< Of the law.
    double change;            ///< Largest of b' - b.
    double changed_residual;  ///< Of the law with b'.
    int point = 0;            ///< After how many points.
  };

  Candidate candidate_of(const ProximalPoint& point) {
    clamped_.lambda = clamp_to_cones(laws_, point.lambda);
    clamped_.complete(motion_);
    Candidate candidate{clamped_.lambda, clamped_.rates + laws_.b, point.modes, 0, 0, 0};
    const double size = size_of_(candidate.lambda);
    candidate.residual = law_residual(laws_, motion_.diagonal(), size, candidate.lambda, candidate.w);
    VecX change = candidate.lambda - from_.lambda;
    for (Index i = 0; i < masses_.size(); ++i) change.segment<3>(3 * i) /= rho_ * masses_(i);
    candidate.change = change.cwiseAbs().maxCoeff();
    // Farther from b it does not count.
    candidate.changed_residual =
        candidate.change <= options_.resolution
            ? law_residual(laws_, motion_.diagonal(), size, candidate.lambda, candidate.w + change)
            : std::numeric_limits<double>::infinity();
    return candidate;
  }

  double least() const { return best_ ? best_->residual : std::numeric_limits<double>::infinity(); }

  /// Keeps the candidate if it is the best so far, of the law with b or of that with b'.
  void keep(Candidate candidate, int point) {
    candidate.point = point;
    const bool is_near =
        candidate.change <= options_.resolution && candidate.changed_residual <= options_.enough;
    if (is_near && (!nearest_ || candidate.change < nearest_->change)) nearest_ = candidate;
    if (candidate.residual < least()) best_ = std::move(candidate);
  }

  CoulombSolution solution_of(const Candidate& candidate, double residual) const {
    return {candidate.lambda, candidate.w,     candidate.modes,
            residual,         candidate.point, residual <= options_.enough,
            "proximal points"};
  }

  const CoulombProblem& laws_;
  const ContactMotion& motion_;
  const std::function<double(const VecX&)>& size_of_;
  const ProximalPointOptions& options_;
  VecX masses_;             ///< effective_masses: n.
  ProximalForces from_;     ///< λ⁰.
  ProximalForces clamped_;  ///< Of the last candidate.
  double rho_;
  SearchByForces by_forces_;
  bool is_bold_;                      ///< Whether the forces are unknowns, too.
  std::optional<Candidate> best_;     ///< Of the least residual.
  std::optional<Candidate> nearest_;  ///< Of those that solve the law with a b' within the resolution.
};

}  // namespace

std::optional<CoulombSolution> solve_by_proximal_points(const CoulombProblem& laws,
                                                        const ContactMotion& motion,
                                                        const std::function<double(const VecX&)>& size_of,
                                                        const ProximalPointOptions& options) {
  std::optional<CoulombSolution> found = ProximalPoints(laws, motion, size_of, options).run();
  const auto is_solved = [&found] { return found && found->converged; };
  const auto keep_better = [&found](std::optional<CoulombSolution> other) {
    if (!found || (other && other->residual < found->residual)) found = std::move(other);
  };
  if (!options.is_bold || is_solved()) return found;

  // Bold steps may lead to where no search gets on. Of many contacts once more from inside, with nearer
  // points: from nothing a search comes less far.
  ProximalPointOptions careful = options;
  if (begins_inside(laws, options)) {
    keep_better(ProximalPoints(laws, motion, size_of, options, kSecondRhoInside).run());
    if (is_solved()) return found;
    if (found) careful.start = found->lambda;
  }

  // Then without bold steps, of few contacts from the beginning.
  careful.is_bold = false;
  keep_better(ProximalPoints(laws, motion, size_of, careful).run());
  return found;
}

}  // namespace rigor
