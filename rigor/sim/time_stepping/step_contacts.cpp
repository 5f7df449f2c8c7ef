#include "rigor/sim/time_stepping/step_contacts.hpp"

#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/core/index.hpp"
#include "rigor/geometry/distance/thickness.hpp"
#include "rigor/sim/pairs/ground_planes.hpp"
#include "rigor/sim/pairs/near_pairs.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace rigor {

namespace {

bool has(const std::vector<Contact>& contacts, const ContactKey& key) {
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const Contact& contact) { return contact.key() == key; });
}

}  // namespace

StepContacts::StepContacts(const Model& model, const Environment& environment, const Method& method)
    : model_(model),
      environment_(environment),
      tolerance_(method.contact_tolerance),
      cone_(method.cone),
      finder_(model, method.broad_phase),
      end_finder_(model, method.broad_phase),
      is_here_(rigor::at(model.body_count()), true) {
  for (int i = 0; i < model.body_count(); ++i) {
    double thickness = std::numeric_limits<double>::infinity(), width = thickness;
    for (const BodyShape& shape : model.body(i).shapes) {
      thickness = std::min(thickness, thickness_of(shape.shape));
      width = std::min(width, smallest_width(shape.shape));
    }
    thickness_.push_back(thickness);
    width_.push_back(width);
  }
}

StepContacts::StepContacts(const StepContacts& other, const Environment& environment, const Method& method)
    : model_(other.model_),
      environment_(environment),
      tolerance_(other.tolerance_),
      cone_(other.cone_),
      finder_(model_, method.broad_phase),
      end_finder_(model_, method.broad_phase),
      thickness_(other.thickness_),
      is_here_(other.is_here_.size(), true),
      width_(other.width_) {}

void StepContacts::look_only_at(const std::vector<bool>& bodies) {
  is_here_ = bodies;
  finder_.look_only_at(bodies);
  end_finder_.look_only_at(bodies);
}

/// Nobody asks for the box of a body that is not there.
Aabb StepContacts::box_of(const State& state, int body) const {
  return is_here_[rigor::at(body)] ? body_box(model_, state, body) : Aabb{Vec3::Zero(), Vec3::Zero()};
}

void StepContacts::begin_step(const State& state) {
  known_.clear();
  ground_.reset();
  boxes_.clear();
  reaches_.clear();
  for (int i = 0; i < model_.body_count(); ++i) boxes_.push_back(box_of(state, i));
}

/// All contacts of a pair at the beginning of the step with gaps up to the margin [m].
const std::vector<Contact>& StepContacts::find(const State& state, const Pair& pair, double margin) {
  const auto [place, is_new] = known_.try_emplace({pair, margin});
  const bool is_near = boxes_[rigor::at(pair.first)].grown(margin).overlaps(boxes_[rigor::at(pair.second)]);
  if (is_new && is_near) place->second = finder_.find(state, pair, {tolerance_, margin});
  return place->second;
}

NearContacts StepContacts::near(const State& state, const Cluster& start,
                                const SpeculativeContacts& speculative) {
  // While no body comes farther, the same pairs are near.
  if (reaches_ != speculative.reaches) {
    pairs_ = finder_.near_pairs(state, speculative.reaches);
    reaches_ = speculative.reaches;
  }
  NearContacts near{pairs_, {}, {}, {}, {}};
  for (const Pair& pair : pairs_) {
    const auto met = speculative.met.find(pair);
    const bool has_met = met != speculative.met.end();

    // Pairs that move far are looked at on their way.
    const bool shows = shows_itself(state, pair, speculative);
    if (moves_far(pair, speculative.reaches)) {
      const bool acts = shows || (has_met && !met->second.empty());
      (acts ? near.watched : near.far).push_back(pair);
    }

    // Contacts within reach, those that may act, and those of later in the step.
    std::vector<Contact> found;
    if (shows) found = find(state, pair, margin(pair, speculative));
    std::copy_if(found.begin(), found.end(), std::back_inserter(near.acting), [&](const Contact& contact) {
      return (has_met && has(met->second, contact.key())) || may_act(contact, start, speculative);
    });
    if (has_met) {
      std::copy_if(met->second.begin(), met->second.end(), std::back_inserter(near.acting),
                   [&](const Contact& contact) { return !has(found, contact.key()); });
    }
    near.found.insert(near.found.end(), found.begin(), found.end());
  }
  std::vector<Contact> planes = near.found;
  planes.insert(planes.end(), near.acting.begin(), near.acting.end());
  ground_.emplace(model_, state, planes);
  ground_->take_out_hidden(near.acting);
  return near;
}

/// Whether the contacts at the beginning show on which side of each other the bodies are: those of bodies
/// that move far only if they touch.
bool StepContacts::shows_itself(const State& state, const Pair& pair,
                                const SpeculativeContacts& speculative) {
  return !moves_far(pair, speculative.reaches) || speculative.met_at_once.contains(pair) ||
         !touching(find(state, pair, tolerance_)).empty();
}

bool StepContacts::moves_far(const Pair& pair, const std::vector<double>& reaches) const {
  constexpr double share = 0.5;
  const auto [a, b] = pair;
  return reaches[rigor::at(a)] + reaches[rigor::at(b)] > share * std::min(thickness(a), thickness(b));
}

/// The largest gap that a pair may close within the step [m].
double StepContacts::margin(const Pair& pair, const SpeculativeContacts& speculative) const {
  return tolerance_ + speculative.reaches[rigor::at(pair.first)] +
         speculative.reaches[rigor::at(pair.second)];
}

/// Contacts may act if they touch or could close within twice the step, at the velocities of its beginning or
/// of its end without contacts.
bool StepContacts::may_act(const Contact& contact, const Cluster& start,
                           const SpeculativeContacts& speculative) const {
  const auto kinetics = [&](int body) {
    return model_.body(body).motion == MotionType::dynamic
               ? dynamic_kinetics(model_.body(body), start.phase_of(body))
               : prescribed_kinetics(model_.body(body), start.t);
  };

  // The rate at which the gap closes, at most.
  const BodyKinetics A = kinetics(contact.body_A), B = kinetics(contact.body_B);
  const Vec3 u = B.velocity_at(contact.p_W()) - A.velocity_at(contact.p_W());
  double rate = std::min(0.0, contact.point.n_W.dot(u));
  // The convex cone pushes on contacts that slide at a distance.
  if (cone_ == ConeMethod::convex) rate -= contact.friction * (u - rate * contact.point.n_W).norm();
  for (const int body : {contact.body_A, contact.body_B}) {
    if (model_.body(body).motion == MotionType::dynamic)
      rate -= speculative.h * environment_.steady_acceleration(body).norm();
  }
  return contact.point.gap <= tolerance_ || contact.point.gap + 2 * speculative.h * rate < 0;
}

bool StepContacts::add_speculative(const State& state, const Cluster& start, const Pair& pair,
                                   const std::array<Pose, 2>& poses, double left,
                                   SpeculativeContacts& speculative) {
  const auto [a, b] = pair;
  std::vector<Contact>& later = speculative.met[pair];
  std::vector<Contact> known = later;
  if (shows_itself(state, pair, speculative)) {
    for (const Contact& contact : find(state, pair, margin(pair, speculative))) {
      if (may_act(contact, start, speculative)) known.push_back(contact);
    }
  }

  // What touches at these poses, and what else may do so in the rest of the step.
  const double near = std::min(tolerance_ + left * margin(pair, speculative),
                               std::max(tolerance_, 0.5 * std::min(thickness(a), thickness(b))));
  const Pose X_WA = pose_of(state, a), X_WB = pose_of(state, b);
  bool is_new = false;
  for (Contact& contact : find_contacts(model_, a, b, poses[0], poses[1], {tolerance_, near})) {
    if (has(known, contact.key())) continue;
    // The same features at the beginning. A surface that the other body comes round to, rather than against,
    // says nothing, and no impact is early by more than the width of a body.
    contact.point = tracked_contact(model_, contact, poses[0], poses[1], X_WA, X_WB);
    const bool is_before = contact.point.gap >= -tolerance_;
    const bool is_close = contact.point.gap <= std::min(width_[rigor::at(a)], width_[rigor::at(b)]);
    if (!is_before || !is_close) continue;
    // A side that is hidden was reached because nothing held the body on the plane before it.
    if (const std::optional<Contact> plane = ground_ ? ground_->plane_before(contact) : std::nullopt) {
      std::vector<Contact>& of_plane = speculative.met[{plane->body_A, plane->body_B}];
      if (has(of_plane, plane->key()) || may_act(*plane, start, speculative)) continue;
      of_plane.push_back(*plane);
      is_new = true;
      continue;
    }
    later.push_back(contact);
    is_new = true;
  }
  return is_new;
}

std::vector<StepContacts::Pair> StepContacts::touching_pairs(const State& state) {
  return end_finder_.near_pairs(state, std::vector<double>(rigor::at(model_.body_count()), 0.5 * tolerance_));
}

std::vector<Contact> StepContacts::at_end(const State& end, const std::vector<Pair>& pairs, WayMemory& ways,
                                          const std::vector<bool>& is_moved) const {
  std::vector<Aabb> boxes;
  boxes.reserve(rigor::at(model_.body_count()));
  for (int i = 0; i < model_.body_count(); ++i) boxes.push_back(box_of(end, i).grown(0.5 * tolerance_));
  const auto moved = [&](int body) { return !is_moved.empty() && is_moved[rigor::at(body)]; };
  std::vector<Contact> contacts;
  for (const Pair& pair : pairs) {
    if (!boxes[rigor::at(pair.first)].overlaps(boxes[rigor::at(pair.second)])) continue;
    const auto find = [&] { return finder_.find(end, pair, {tolerance_, tolerance_}); };
    const std::vector<Contact> found =
        moved(pair.first) || moved(pair.second) ? find() : ways.contacts_at_end(pair, find);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

bool StepContacts::may_bounce(const Pair& pair) const {
  for (const BodyShape& of_first : model_.body(pair.first).shapes) {
    for (const BodyShape& of_second : model_.body(pair.second).shapes) {
      if (model_.coefficients(of_first.material, of_second.material).restitution > 0) return true;
    }
  }
  return false;
}

bool StepContacts::are_close(const State& end, const Pair& pair) const {
  constexpr double share_of_thickness = 0.1;
  const double reach =
      std::max(tolerance_, share_of_thickness * std::min(thickness(pair.first), thickness(pair.second)));
  return !finder_.find(end, pair, {tolerance_, reach}).empty();
}

std::vector<Contact> StepContacts::at(const State& state, const std::vector<double>& reaches) {
  return end_finder_.find(state, reaches, tolerance_);
}

std::vector<Contact> StepContacts::touching(const std::vector<Contact>& contacts) const {
  std::vector<Contact> touching;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(touching),
               [this](const Contact& contact) { return contact.point.gap <= tolerance_; });
  return touching;
}

}  // namespace rigor
