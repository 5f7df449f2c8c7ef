#pragma once

#include "rigor/contact/system/contact_system.hpp"
#include "rigor/dynamics/environment.hpp"

#include <vector>

namespace rigor {

/// Dynamic bodies at an instant with all contacts that they have there: what an event is about.
struct Cluster {
  double t = 0;                   ///< [s].
  std::vector<int> bodies;        ///< Dynamic, ascending.
  std::vector<BodyPhase> phases;  ///< One per body.
  std::vector<Contact> contacts;  ///< Among these bodies and with prescribed ones.
  double slip_tolerance = 0;      ///< Slower slip counts as sticking [m/s].
  double least_impact = 0;        ///< Slower approach is ended without an impact [m/s].

  BodyPhase& phase_of(int body);
  const BodyPhase& phase_of(int body) const { return const_cast<Cluster*>(this)->phase_of(body); }
};

/// Parts of a cluster that are joined neither by contacts (of the given list) between dynamic bodies nor by
/// joints or springs, in the order of their first bodies. Each has its share of the given contacts.
std::vector<Cluster> connected_parts(const Cluster& cluster, const std::vector<Contact>& contacts,
                                     const Environment& environment);

/// Adds impulses, one per body of the system (those of prescribed bodies are left out), to the momenta.
void add_to_momenta(const ContactSystem& system, const std::vector<Wrench>& impulses, Cluster& cluster);

}  // namespace rigor
