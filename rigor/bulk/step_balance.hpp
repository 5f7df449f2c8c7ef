#pragma once

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/direct/direct_islands.hpp"
#include "rigor/core/index.hpp"

#include <vector>

namespace rigor {

struct BulkStepReport;

/// What a step was given and what it made of it: impacts, work, linear momentum. Momentum is balanced over
/// the dynamic bodies that joints do not tie to bodies of other kinds or to the world: its change is the
/// impulse of forces and of contacts with all other bodies, or there is an error (of rounding, or in the
/// solver).
class StepBalance {
 public:
  explicit StepBalance(const Model& model);

  /// Before the first substep and before islands are solved directly.
  void begin(const BulkBodies& bodies);
  /// After the last one, before bodies are moved. accelerations: of forces in a step of h [s].
  void end(const BulkBodies& bodies, const std::vector<MotionRow>& accelerations, double h,
           const BulkContacts& contacts, const DirectIslands& direct, BulkStepReport& report) const;

 private:
  /// Impulse on B.
  void book(const BulkBodies& bodies, int body_A, int body_B, const Vec3& impulse, Vec3& given) const;
  bool is_booked(const BulkBodies& bodies, int body) const {
    return is_free_[at(body)] && bodies.is_dynamic(body);
  }
  Vec3 momentum(const BulkBodies& bodies) const;

  std::vector<double> masses_;  ///< [kg].
  std::vector<bool> is_free_;
  Vec3 begin_ = Vec3::Zero();  ///< Momentum at the begin [kg m/s].
};

}  // namespace rigor
