#include "rigor/bulk/bulk_events.hpp"

#include "rigor/bulk/contacts/bulk_contacts.hpp"
#include "rigor/bulk/contacts/contact_measures.hpp"
#include "rigor/core/index.hpp"
#include "rigor/model/contact_key.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace rigor {

namespace {

/// The key of an event: all manifolds of a pair of shapes are one event.
ContactKey key_of(const ContactEvent& event) {
  return {event.body_A, event.body_B, event.shape_A, event.shape_B, 0};
}

/// The pairs of shapes that press on each other, each with its impulse.
std::vector<ContactEvent> pressing_pairs(const ManifoldMemories& memory, ContactEvent::Kind kind) {
  std::vector<ContactEvent> pairs;
  for (const ManifoldMemory& manifold : memory) {
    // Only manifolds with an impulse press, however near the shapes are.
    float impulse = 0;
    for (int i = 0; i < manifold.point_count; ++i) impulse += manifold.normal_impulse[at(i)];
    if (!(impulse > 0)) continue;
    const ContactEvent pair{kind,   manifold.body_A, manifold.body_B, manifold.shape_A, manifold.shape_B,
                            impulse};
    // Manifolds of one pair follow each other in the order of keys.
    if (!pairs.empty() && key_of(pairs.back()) == key_of(pair)) {
      pairs.back().normal_impulse += impulse;
    } else {
      pairs.push_back(pair);
    }
  }
  return pairs;
}

}  // namespace

std::vector<ContactEvent> contact_events(const ManifoldMemories& before, const ManifoldMemories& after) {
  const std::vector<ContactEvent> old_pairs = pressing_pairs(before, ContactEvent::Kind::end);
  const std::vector<ContactEvent> new_pairs = pressing_pairs(after, ContactEvent::Kind::begin);
  std::vector<ContactEvent> events;
  // Both lists are in the order of keys: what is in one of them alone ended or began.
  std::size_t i = 0, k = 0;
  while (i < old_pairs.size() || k < new_pairs.size()) {
    const bool has_both = i < old_pairs.size() && k < new_pairs.size();
    // A pair that is in both lists pressed before and still does: that is no event.
    if (has_both && key_of(old_pairs[i]) == key_of(new_pairs[k])) {
      ++i, ++k;
    } else if (k == new_pairs.size() || (has_both && key_of(old_pairs[i]) < key_of(new_pairs[k]))) {
      events.push_back(old_pairs[i++]);
    } else {
      events.push_back(new_pairs[k++]);
    }
  }
  return events;
}

namespace {

BulkContact read_contact(const SolvedManifold& manifold, const StepManifolds& manifolds, std::size_t number,
                         const BulkBodies& bodies) {
  const ShapePair& pair = manifolds.pair(number);
  const std::size_t a = at(pair.body_A);
  const ManifoldFrame& frame = manifold.frame;
  const float* moved = bodies.motion[a].dp;
  BulkContact contact;
  contact.body_A = pair.body_A, contact.body_B = pair.body_B;
  contact.shape_A = pair.shape_A, contact.shape_B = pair.shape_B;
  contact.part = manifolds.part(number);
  contact.n_W = frame.n;
  // Places are those of the beginning of the step, when the contact was found; bodies have moved since.
  contact.center_W = bodies.x[a] - Vec3(moved[0], moved[1], moved[2]) + found_arm(manifold, bodies);
  contact.point_count = manifolds.point_count(number);
  // Points, with the impulses that they had in the whole step.
  for (std::size_t k = 0; k < at(contact.point_count); ++k) {
    const SolvedManifold::Point& point = manifold.points[k];
    contact.points[k] = {contact.center_W + point.p1 * frame.t1 + point.p2 * frame.t2, point.gap,
                         manifold.impulses.normal[k]};
  }
  // Friction acts at the centre; twisting and rolling are moments about n and about t1, t2.
  const double f1 = manifold.impulses.tangent[0], f2 = manifold.impulses.tangent[1];
  const double twist = manifold.impulses.twist;
  contact.friction_impulse_W = f1 * frame.t1 + f2 * frame.t2;
  const double r1 = manifold.impulses.roll[0], r2 = manifold.impulses.roll[1];
  contact.friction_moment_W = twist * frame.n + r1 * frame.t1 + r2 * frame.t2;
  contact.approach_speed = approach_speed(manifold);
  contact.is_new = manifolds.is_new(number);
  return contact;
}

}  // namespace

void read_contacts(const BulkContacts& contacts, const BulkBodies& bodies,
                   const std::function<void(std::size_t, const BulkContact&)>& visit) {
  contacts.for_contacts([&](const SolvedManifold& manifold, std::size_t number) {
    visit(number, read_contact(manifold, contacts.manifolds(), number, bodies));
  });
}

std::vector<BulkContact> find_hits(const std::vector<BulkContact>& contacts, double least_speed) {
  std::vector<BulkContact> hits;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(hits), [&](const BulkContact& contact) {
    return contact.is_new && contact.normal_impulse() > 0 && contact.approach_speed >= least_speed;
  });
  return hits;
}

}  // namespace rigor
