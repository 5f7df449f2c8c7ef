#include "rigor/sim/islands/cluster.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

/// Representatives of a partition, with path halving.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t k) {
    const std::size_t a = find(i), b = find(k);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

BodyPhase& Cluster::phase_of(int body) {
  const std::size_t place = place_of(bodies, body);
  RIGOR_ASSERT(place < bodies.size() && bodies[place] == body);
  return phases[place];
}

std::vector<Cluster> connected_parts(const Cluster& cluster, const std::vector<Contact>& contacts,
                                     const Environment& environment) {
  // Bodies that contacts, springs or joints connect are of one part.
  Partition partition(cluster.bodies.size());
  for (const Contact& contact : contacts) {
    if (!holds(cluster.bodies, contact.body_A) || !holds(cluster.bodies, contact.body_B)) continue;
    partition.join(place_of(cluster.bodies, contact.body_A), place_of(cluster.bodies, contact.body_B));
  }
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    for (const std::vector<int>* partners :
         {&environment.spring_partners(cluster.bodies[i]), &environment.joint_partners(cluster.bodies[i])}) {
      for (const int partner : *partners) {
        if (holds(cluster.bodies, partner)) partition.join(i, place_of(cluster.bodies, partner));
      }
    }
  }

  // The bodies of each part, in the order of their first ones, which represent them.
  std::vector<Cluster> parts;
  std::vector<std::size_t> part_of(cluster.bodies.size());
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const std::size_t first = partition.find(i);
    if (first == i) {
      part_of[i] = parts.size();
      Cluster& part = parts.emplace_back();
      part.t = cluster.t;
      part.slip_tolerance = cluster.slip_tolerance;
      part.least_impact = cluster.least_impact;
    }
    Cluster& part = parts[part_of[first]];
    part.bodies.push_back(cluster.bodies[i]);
    part.phases.push_back(cluster.phases[i]);
  }

  // Then its contacts, in the order of the cluster.
  for (const Contact& contact : contacts) {
    const int body = holds(cluster.bodies, contact.body_A) ? contact.body_A : contact.body_B;
    parts[part_of[partition.find(place_of(cluster.bodies, body))]].contacts.push_back(contact);
  }
  return parts;
}

void add_to_momenta(const ContactSystem& system, const std::vector<Wrench>& impulses, Cluster& cluster) {
  for (std::size_t i = 0; i < cluster.bodies.size(); ++i) {
    const Wrench& impulse = impulses[at(system.local_index(cluster.bodies[i]))];
    cluster.phases[i].P += impulse.f_W;
    cluster.phases[i].L += impulse.tau_W;
  }
}

}  // namespace rigor
