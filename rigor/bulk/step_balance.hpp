#pragma once

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/direct/direct_islands.hpp"
#include "rigor/core/index.hpp"

#include <vector>

namespace rigor {

struct BulkStepReport;

/// The balance of a step: impacts, work, linear momentum. Momentum is balanced over the dynamic bodies that
/// joints do not tie to bodies of other kinds or to the world: its change is the impulse of forces and of
/// contacts with all other bodies; what is left is an error (of rounding, or in the solver).
class StepBalance {
 public:
  explicit StepBalance(const Model& model);

  /// After the Model has changed.
  void change(const Model& model, const ChangedBodies& changed);

  /// Begins the balance, before the first substep and before islands are solved directly.
  void begin(const BulkBodies& bodies);
  /// Ends the balance, after the last substep and before bodies are moved. `accelerations` are those of
  /// forces in a step of h [s].
  void end(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations, double h,
           const BulkContacts& contacts, const DirectIslands& direct, BulkStepReport& report) const;

 private:
  void find_free(const Model& model);
  /// Adds to `given` what an impulse on B gives to the bodies of the balance, if it is not between two of
  /// them.
  void book(const BulkBodies& bodies, int body_A, int body_B, const Vec3& impulse, Vec3& given) const;
  bool is_booked(const BulkBodies& bodies, int body) const {
    return is_free_[at(body)] && bodies.is_dynamic(body);
  }
  Vec3 momentum(const BulkBodies& bodies) const;
  double sum_of_momenta(const BulkBodies& bodies) const;

  std::vector<double> masses_;  ///< [kg].
  std::vector<bool> is_free_;
  Vec3 begin_ = Vec3::Zero();  ///< Momentum at the beginning [kg m/s].
  double momenta_ = 0;         ///< Sum of the bodies' own, Σ m |v|, at the beginning [kg m/s].
};

}  // namespace rigor
