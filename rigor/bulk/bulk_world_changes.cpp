#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/bulk_world_scratch.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/sorted_unique.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rigor {

void BulkWorld::change_body(int body) {
  Scratch& s = *scratch_;
  changes_.bodies.push_back(body);
  changes_.is_new.resize(bodies_.x.size(), 0);
  changes_.is_new[at(body)] = 1;
  // What is asked of the body before the next step.
  s.forces.clear_given(body);
  s.prescribed.set_body(*model_, body);
  read_changed_body(*model_, body, t_, bodies_);
  if (!s.sleepers) return;
  s.sleepers->disturb(body);
  // What a body meets that does not move may sleep, and nothing else would look for it.
  if (model_->body(body).motion != MotionType::dynamic && !model_->body(body).shapes.empty())
    s.sleepers->disturb_all();
}

void BulkWorld::change_filter(int body) {
  changes_.filters.push_back(body);
  if (!scratch_->sleepers) return;
  scratch_->sleepers->disturb(body);
  if (model_->body(body).motion != MotionType::dynamic) scratch_->sleepers->disturb_all();
}

void BulkWorld::change_joints(const std::vector<int>& was, const std::vector<int>& concerned) {
  constexpr std::size_t width = 6;
  changes_.are_ties_new = true;
  // Joints keep the impulses of the step before.
  std::vector<float> impulses(width * was.size(), 0);
  for (std::size_t i = 0; i < was.size(); ++i) {
    if (was[i] >= 0 && width * at(was[i]) < scratch_->joint_impulses.size())
      std::copy_n(&scratch_->joint_impulses[width * at(was[i])], width, &impulses[width * i]);
  }
  scratch_->joint_impulses = std::move(impulses);
  changes_.filters.insert(changes_.filters.end(), concerned.begin(), concerned.end());
  if (!scratch_->sleepers) return;
  for (const int body : concerned) scratch_->sleepers->disturb(body);
}

void BulkWorld::change_laws(int joint) {
  scratch_->joints->take_limits();
  if (!scratch_->sleepers) return;
  for (const int body : model_->bodies_of_joint(joint)) scratch_->sleepers->disturb(body);
}

void BulkWorld::change_surfaces() {
  changes_.are_surfaces_new = true;
}

void BulkWorld::change_gravity() {
  scratch_->tilts.set_gravity(*model_);
  scratch_->direct.set_gravity();
  scratch_->energy_bound.set_gravity();
  scratch_->forces.set_gravity();
}

void BulkWorld::take_given(const BulkWorld& from) {
  scratch_->forces.take_given(from.scratch_->forces);
  scratch_->prescribed.take_targets(from.scratch_->prescribed);
}

void BulkWorld::settle_changes() {
  if (std::exchange(changes_.are_surfaces_new, false)) scratch_->contacts.set_surfaces(*model_);
  if (!changes_.is_any()) return;
  Scratch& s = *scratch_;
  const std::vector<int> bodies = sorted_unique(std::move(changes_.bodies));
  const ChangedBodies changed{bodies, changes_.are_ties_new};
  forget_contacts_of_changed();
  // Tables of bodies, then of what holds them together.
  for (const int body : bodies) {
    s.contacts.set_body(*model_, body);
    s.tilts.set_body(*model_, body);
    s.gyroscopic_terms.set_body(*model_, body);
    if (!s.turns.empty()) s.turns[at(body)] = {};  // Round bodies keep theirs.
  }
  s.narrow_phase.set_bodies(*model_, bodies);
  s.direct.change(changed);
  s.bounce_limits.change(changed);
  s.energy_bound.change(changed);
  s.passing.change(changed);
  s.balance.change(*model_, changed);
  s.forces.change(changed);
  if (s.sleepers) s.sleepers->change(changed);
  if (changed.are_ties_new) s.joints.emplace(*model_);
  s.held.unmark(bodies_);
  s.held = HeldBodies(*model_);
  s.impacts.find_jointed();
  // Who may meet whom.
  for (const int body : changes_.filters) s.passing.set_filter(body);
  if (changed.are_ties_new) s.pair_finder.set_excluded(*model_);
  std::vector<int> searched = std::move(changes_.filters);
  searched.insert(searched.end(), bodies.begin(), bodies.end());
  s.pair_finder.set_bodies(*model_, sorted_unique(std::move(searched)));
  changes_ = {};
}

/// Contacts of bodies that came, went or changed are forgotten; what was in contact with them wakes.
void BulkWorld::forget_contacts_of_changed() {
  if (changes_.is_new.empty()) return;
  const auto is_new = [&](int body) { return changes_.is_new[at(body)] != 0; };
  ManifoldMemories kept;
  bool is_any_gone = false;
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    const int a = memory_.body_A(i), b = memory_.body_B(i);
    is_any_gone = is_any_gone || is_new(a) || is_new(b);
    if (!scratch_->sleepers || is_new(a) == is_new(b)) continue;
    scratch_->sleepers->disturb(is_new(a) ? b : a);
  }
  if (!is_any_gone) return;
  for (std::size_t i = 0; i < memory_.size(); ++i) {
    if (!is_new(memory_.body_A(i)) && !is_new(memory_.body_B(i))) kept.push_back(memory_[i]);
  }
  memory_ = std::move(kept);
}

}  // namespace rigor
