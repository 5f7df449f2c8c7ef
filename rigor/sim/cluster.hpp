#pragma once

#include "rigor/contact/impact.hpp"
#include "rigor/contact/resting.hpp"
#include "rigor/dynamics/environment.hpp"
#include "rigor/sim/advance_report.hpp"
#include "rigor/sim/island.hpp"
#include "rigor/sim/method.hpp"

#include <vector>

namespace rigor {

/// Dynamic bodies at an instant with all contacts that they have there: what an event is about.
struct Cluster {
  double t = 0;                   ///< [s].
  std::vector<int> bodies;        ///< Dynamic, ascending.
  std::vector<BodyPhase> phases;  ///< One a body.
  std::vector<Contact> contacts;  ///< Among these bodies and with prescribed ones.
  double slip_tolerance = 0;      ///< Slower slip counts as sticking [m/s].
  double least_impact = 0;        ///< Slower approach is ended without an impact [m/s].

  BodyPhase& phase_of(int body);
  const BodyPhase& phase_of(int body) const { return const_cast<Cluster*>(this)->phase_of(body); }
};

/// Parts of a cluster that are joined neither by contacts (of the given list) between dynamic bodies nor by
/// joints or springs, in the order of their first bodies. Each takes its own contacts along, from the given
/// list.
std::vector<Cluster> connected_parts(const Cluster& cluster, const std::vector<Contact>& contacts,
                                     const Environment& environment);

/// What lasts after an event: contacts that hold, with what they do.
struct LastingContacts {
  std::vector<Contact> contacts;
  std::vector<ContactState> states;
  /// Whether forces were found that keep them. Where bodies jam there are none (Painlevé): sliding contacts
  /// can need more force than any.
  bool have_forces = true;
};

/// Decides what happens at an event: who collides, who rests, who parts.
class ContactResolver {
 public:
  ContactResolver(const Model& model, const IslandIntegrator& integrator, const Method& method);

  /// Stops of the joints of the cluster's bodies: limits that are reached, dry friction, motors.
  std::vector<Contact> stops_of(const Cluster& cluster) const;
  /// Puts bodies back to where their joints hold, by the smallest displacements in the metric of the mass
  /// matrix (Newton's method); the momenta stay. One phase a body, of dynamic bodies with all that are
  /// jointed to them.
  void project_joints(double t, const std::vector<int>& bodies, std::vector<BodyPhase>& phases,
                      AdvanceReport& report) const;
  /// Gives bodies that joints hold to each other and to nothing else the sums of momenta that the impulses of
  /// the step say, by a velocity as of one rigid body, which no joint notices: what the integrator and the
  /// projection of positions leave would else add up. Other islands stay as they are; so do those with
  /// contacts after an accurate step.
  void restore_momenta(const Island& island, IslandStep& step) const;
  /// Puts velocities back to what the joints allow: the projection in the metric of the mass matrix.
  void project_joint_velocities(Cluster& cluster, AdvanceReport& report) const;
  /// Puts bodies that overlap noticeably back to touching, by the smallest displacement in the metric of the
  /// mass matrix; the momenta stay. Returns whether anything moved: then the contacts must be found anew.
  bool project_positions(Cluster& cluster) const;
  /// Impulses until no contact approaches; false if some still do. Changes the momenta of the cluster's
  /// bodies.
  bool apply_impulses(Cluster& cluster, AdvanceReport& report) const;
  /// Which contacts last: those that do not part and carry a force. The momenta are projected on what they
  /// allow.
  LastingContacts update_active(Cluster& cluster, AdvanceReport& report) const;
  /// Whether bodies with these lasting contacts stand still and stay so: all forces balance.
  bool is_balanced(const Cluster& cluster, const LastingContacts& lasting) const;

  /// The contacts of the cluster with all bodies that they touch.
  ContactSystem system_of(const Cluster& cluster, const std::vector<Contact>& contacts) const;

 private:
  /// Adds these impulses on the bodies of the system (of prescribed ones none) to the momenta.
  void add_to_momenta(const ContactSystem& system, const std::vector<Wrench>& impulses,
                      Cluster& cluster) const;
  /// Ends an approach slower than any impact (what the error of a step leaves at a lasting contact): the
  /// nearest velocities in the metric of the mass matrix at which nothing approaches.
  void settle(const ContactSystem& system, const VecX& u, Cluster& cluster, AdvanceReport& report) const;
  std::vector<double> restitutions(const Cluster& cluster, const ContactSystem& system,
                                   AdvanceReport& report) const;
  /// moments: angular impulses in the contact frames, 3n, or none.
  void add_impulses(const ContactSystem& system, const VecX& lambda, const VecX& moments, Cluster& cluster,
                    AdvanceReport& report) const;

  const Model& model_;
  const IslandIntegrator& integrator_;
  RestitutionLaw collision_law_;
  SimultaneousLaw law_;
  double resting_velocity_;
  double contact_tolerance_;
  RestingChoice resting_;
};

}  // namespace rigor
