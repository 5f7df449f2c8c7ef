#pragma once

#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/method/method.hpp"
#include "rigor/sim/report/advance_report.hpp"

#include <vector>

namespace rigor {

/// Puts positions back where contacts want them, and sees that no energy comes of it
/// (docs/decisions/0010-positions-put-back.md).
class ContactProjection {
 public:
  ContactProjection(const Model& model, const Environment& environment,
                    const ContactSystemAssembler& assembler, const Method& method);

  /// Lasting contacts keep their gaps: what the error of the integrator has added to them in a step is
  /// taken back, by the smallest displacement in the metric of the mass matrix. It adds no energy: what it
  /// would add is taken from the motion, and bodies that cannot pay stay where the step has left them.
  void restore_gaps(const Island& island, double t, IslandStep& step) const;
  /// Parts bodies of the island that were pushed into each other as they were moved from `before` to
  /// `phases`, by the smallest displacement that their joints allow (in the metric of the mass matrix): a
  /// taut chain of joints turns a small error along itself into a large motion across. Each body keeps its
  /// momentum, and its angular momentum about the origin. Returns whether anything moved.
  bool part_pushed(const Island& island, double t, const std::vector<BodyPhase>& before,
                   std::vector<BodyPhase>& phases) const;
  /// Puts bodies that overlap noticeably back to touching, by the smallest displacement in the metric of the
  /// mass matrix; the momenta stay, but for what pays for the lift. Returns whether anything moved: then the
  /// contacts must be found anew. Where the overlaps are `given`, by a scene or by another scheme, nobody
  /// owes the lift: what the motion does not pay is work done on the bodies.
  bool project_positions(Cluster& cluster, bool are_given, AdvanceReport& report) const;

 private:
  const Model& model_;
  const Environment& environment_;
  const ContactSystemAssembler& assembler_;
  double contact_tolerance_;
  RestingChoice resting_;
};

}  // namespace rigor
