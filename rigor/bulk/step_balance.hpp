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
  void list_free();
  bool is_booked(const BulkBodies& bodies, int body) const {
    return is_free_[at(body)] != 0 && bodies.is_dynamic(body);
  }
  /// Of the bodies of the balance [kg m/s].
  struct Momenta {
    Vec3 sum = Vec3::Zero();
    double sum_of_norms = 0;  ///< Without the bits of velocities beyond 32.
  };
  Momenta momenta_of(const BulkBodies& bodies) const;

  std::vector<double> masses_;  ///< [kg].
  std::vector<char> is_free_;   ///< Of each body: whether its momentum is balanced while it is awake.
  std::vector<int> free_;       ///< Those of which it is.
  Momenta begin_;
};

}  // namespace rigor
