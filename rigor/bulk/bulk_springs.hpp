#pragma once

#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/model/model.hpp"

#include <array>
#include <vector>

namespace rigor {

/// Springs and dampers between points of bodies in the steps of the many-body path. Each force is constant in
/// a step and follows from how the step would go on with it, so that none is too stiff: soft springs neither
/// gain nor lose energy, stiff ones come to rest at once. All springs are solved together.
///
/// Derivation: section 5 of docs/theory/bulk.md.
class BulkSprings {
 public:
  explicit BulkSprings(const Model& model);

  /// Adds to the changes of the velocities per second, which are those of all other forces, what the springs
  /// change in a step of h [s].
  void add(const BulkBodies& bodies, double h, int substeps, std::vector<MotionRow>& accelerations) const;
  /// Sets the marks of the bodies, by body, that springs hold.
  void mark_bodies(std::vector<char>& marks) const;

 private:
  /// Changes of velocities per second, linear first: forces on light bodies cancel up to a small rest.
  using Motions = std::vector<Eigen::Matrix<double, 6, 1>>;
  /// A step of h [s], in which bodies with an acceleration a that is constant in it move by h u + β h² a.
  struct Span {
    double h, beta;
  };
  /// A spring somewhere: its arms and its line, unit or 0, from A to B in W.
  struct Place {
    Vec3 r_A, r_B, line;
    double stretch;  ///< [m].
  };
  /// A body at one end: the change of its velocities by a unit impulse along the line.
  struct End {
    int body;                         ///< Model index; world_body.
    Vec3 direction, moment;           ///< Unit impulse along the line, and its moment about the centre.
    Vec3 dv = Vec3::Zero(), dw = dv;  ///< [1/kg], [rad/(kg m)].
  };
  /// A spring in a step, and the impulse ν = impulse - slope A ν that it gives.
  struct Row {
    End A, B;
    double stiff = 0;     ///< h² k + h d times the mobility.
    double mobility = 0;  ///< Change of the rate by a unit impulse [1/kg].
    double slope = 0;     ///< Impulse lost per rate that the springs change [kg].
    double impulse = 0;   ///< With rates that the springs do not change [N s].
  };
  Place place_between(const Spring& spring, const std::array<Vec3, 2>& arms, const Vec3& between) const;
  Place begin_of(const Spring& spring, const BulkBodies& bodies) const;
  /// At the end of a step with these accelerations.
  Place end_of(const Spring& spring, const BulkBodies& bodies, const Span& span,
               const Motions& accelerations) const;
  Row line_up(const Spring& spring, const Place& place, const BulkBodies& bodies) const;
  /// What these changes per second of velocities make of the rate of the length [m/s²].
  static double along(const Row& row, const Motions& rows, const BulkBodies& bodies);
  /// By all other forces, and with springs as they were found last.
  struct Accelerations {
    const Motions &others, &before;
  };
  Row row_of(const Spring& spring, const BulkBodies& bodies, const Span& span,
             const Accelerations& accelerations) const;
  static double later_share(const Spring& spring, const Span& span, double mobility);
  std::vector<Row> rows_of(const BulkBodies& bodies, const Span& span,
                           const Accelerations& accelerations) const;
  double merit(const BulkBodies& bodies, const Span& span, const Motions& others, const Motions& all) const;
  Motions solve(const BulkBodies& bodies, const Span& span, const Motions& others) const;
  double approach(const BulkBodies& bodies, const Span& span, const Accelerations& accelerations,
                  Motions& next) const;
  static void apply_force(const Row& spring, double force, Motions& accelerations);
  VecX impulses_of(const std::vector<Row>& rows, std::size_t body_count) const;

  const Model* model_;
  std::vector<Spring> springs_;  ///< Those with stiffness or damping.
};

}  // namespace rigor
