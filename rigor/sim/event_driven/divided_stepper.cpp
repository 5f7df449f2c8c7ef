#include "rigor/sim/event_driven/divided_stepper.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/work_count.hpp"
#include "rigor/sim/pairs/remembered_forces.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

/// More groups than these are dealt out to as many: each costs something.
constexpr std::size_t most_shares = 32;
/// So many bodies close together are a crowd, though they do not touch yet; gases have pairs.
constexpr std::size_t crowd = 4;

/// Which of the bodies the memory of a contact is kept with: the order in which one stepper would list them.
int keeper_of(const Model& model, const ContactMemory& contact) {
  return model.body(contact.body_B).motion == MotionType::dynamic ? contact.body_B : contact.body_A;
}

template <class T>
void copy_part(const std::vector<T>& from, std::vector<T>& to, int body, int size) {
  std::copy_n(from.begin() + size * body, size, to.begin() + size * body);
}

void copy_body(const State& from, State& to, int body) {
  copy_part(from.x, to.x, body, 3);
  copy_part(from.q, to.q, body, 4);
  copy_part(from.P, to.P, body, 3);
  copy_part(from.L, to.L, body, 3);
  copy_part(from.epoch, to.epoch, body, 1);
  copy_part(from.anchor, to.anchor, body, 13);
}

/// The groups as at most so many, the largest first to those that have fewest bodies yet.
std::vector<BodyGroup> dealt_out(std::vector<BodyGroup> groups, std::size_t most) {
  if (groups.size() <= most) return groups;
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BodyGroup& a, const BodyGroup& b) { return a.size() > b.size(); });
  std::vector<BodyGroup> hands(most);
  for (const BodyGroup& group : groups) {
    BodyGroup& smallest =
        *std::min_element(hands.begin(), hands.end(),
                          [](const BodyGroup& a, const BodyGroup& b) { return a.size() < b.size(); });
    smallest.insert(smallest.end(), group.begin(), group.end());
  }
  for (BodyGroup& hand : hands) std::sort(hand.begin(), hand.end());
  return hands;
}

}  // namespace

DividedStepper::DividedStepper(std::shared_ptr<const Model> model, const Method& method, Make make,
                               int threads)
    : model_(std::move(model)),
      environment_(*model_),
      contact_tolerance_(method.contact_tolerance),
      has_lasting_contacts_(method.scheme != Scheme::impulse_based),
      make_(std::move(make)),
      executor_(threads),
      work_(at(model_->body_count())) {}

EventDrivenStepper& DividedStepper::whole() {
  if (!whole_) {
    whole_ = make_();
    whole_->set_interrupt([this] { return is_interrupted(); });
  }
  return *whole_;
}

std::optional<std::vector<TouchingPoint>> DividedStepper::contacts_of(const State& state) const {
  if (group_count_ == 1) return whole_ ? whole_->contacts_of(state) : std::nullopt;
  if (!has_lasting_contacts_) return std::nullopt;
  return touching_points(*model_, state, touching_contacts(*model_, state, contact_tolerance_),
                         forces_in(state));
}

AdvanceReport DividedStepper::advance_span(State& state, double t_end) {
  RIGOR_ASSERT(t_end >= state.t && state.body_count() == model_->body_count());
  t_ = state.t;
  std::vector<BodyGroup> groups = divide(state, t_end);
  if (groups.size() < 2) return advance_whole(state, t_end);

  // Each group by itself; those that could have met, as one.
  std::vector<Share> shares;
  for (std::size_t advanced = 0; true; advanced = shares.size()) {
    for (const BodyGroup& group : groups) {
      const bool is_known = std::any_of(shares.begin(), shares.end(),
                                        [&](const Share& share) { return share.bodies == group; });
      if (!is_known) shares.push_back(share_of(group, state));
    }
    advance_shares(shares, advanced, t_end);
    const bool are_at_end = std::all_of(shares.begin(), shares.end(), [](const Share& share) {
      return share.report.reason == StopReason::reached_end;
    });
    // Where one stops all have to, at one time.
    if (!are_at_end) break;
    const std::vector<BodyGroup> met = joined(shares);
    if (met.size() == shares.size()) {
      group_count_ = shares.size();
      AdvanceReport report = put_together(shares, state);
      retire(std::move(shares));
      return report;
    }
    if (met.size() < 2) break;
    std::erase_if(shares, [&](const Share& share) {
      return std::find(met.begin(), met.end(), share.bodies) == met.end();
    });
    groups = met;
  }
  retire(std::move(shares));
  return advance_whole(state, t_end);
}

AdvanceReport DividedStepper::advance_whole(State& state, double t_end) {
  group_count_ = 1;
  return whole().advance(state, t_end);
}

/// Groups worth a thread: crowds, and bodies whose motion is integrated, since they touch or forces act on
/// them. All others, which fly, are one more.
std::vector<BodyGroup> DividedStepper::divide(const State& state, double t_end) const {
  std::vector<bool> is_integrated(at(model_->body_count()));
  for (const ContactMemory& contact : state.events.contacts) {
    is_integrated[at(contact.body_A)] = true;
    is_integrated[at(contact.body_B)] = true;
  }
  for (int body = 0; body < model_->body_count(); ++body) {
    if (is_dynamic(body) && environment_.is_forced(body)) is_integrated[at(body)] = true;
  }

  std::vector<BodyGroup> worth;
  BodyGroup others;
  for (BodyGroup& group : groups_apart(*model_, environment_, state, t_end, contact_tolerance_)) {
    const bool is_worth = group.size() >= crowd || std::any_of(group.begin(), group.end(),
                                                               [&](int b) { return is_integrated[at(b)]; });
    if (is_worth) {
      worth.push_back(std::move(group));
    } else {
      others.insert(others.end(), group.begin(), group.end());
    }
  }
  if (worth.size() < 2) return {};
  worth = dealt_out(std::move(worth), most_shares);
  std::sort(others.begin(), others.end());
  if (!others.empty()) worth.push_back(std::move(others));
  return worth;
}

/// What the group needs to go on: that of an earlier span, if it had the same bodies.
DividedStepper::Share DividedStepper::share_of(const BodyGroup& bodies, const State& state) {
  std::vector<bool> is_here(at(model_->body_count()));
  for (const int body : bodies) is_here[at(body)] = true;
  Share share;
  const auto same = std::find_if(idle_.begin(), idle_.end(),
                                 [&](const Share& earlier) { return earlier.bodies == bodies; });
  if (same != idle_.end()) {
    share = std::move(*same);
    idle_.erase(same);
  } else {
    share.bodies = bodies;
    share.stepper = make_();
    share.stepper->advance_only(is_here, whole().witness());
  }
  share.state = state;
  std::erase_if(share.state.events.contacts, [&](const ContactMemory& contact) {
    return !is_here[at(contact.body_A)] && !is_here[at(contact.body_B)];
  });
  return share;
}

/// Keeps what groups know for the next span.
void DividedStepper::retire(std::vector<Share> shares) {
  idle_ = std::move(shares);
}

/// Advances shares from the first on to t_end, on the threads.
void DividedStepper::advance_shares(std::vector<Share>& shares, std::size_t first, double t_end) {
  // Those that took long before begin first, so that the threads end together; whoever is free takes the next
  // one.
  std::vector<std::size_t> order(shares.size() - first);
  std::iota(order.begin(), order.end(), first);
  const auto foreseen = [&](std::size_t share) {
    double work = 0;
    for (const int body : shares[share].bodies) work += 1 + work_[at(body)];
    return work;
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return foreseen(a) > foreseen(b); });
  const std::function<bool()> interrupt = shared_interrupt();
  std::atomic<std::size_t> next{0};
  executor_.for_ranges(executor_.threads(), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      for (std::size_t i = next++; i < order.size(); i = next++)
        advance_share(shares[order[i]], t_end, interrupt);
    }
  });
  for (const std::size_t i : order) {
    if (shares[i].report.reason == StopReason::interrupted) throw Interrupted();
    for (const int body : shares[i].bodies)
      work_[at(body)] = shares[i].work / static_cast<double>(shares[i].bodies.size());
  }
}

void DividedStepper::advance_share(Share& share, double t_end, const std::function<bool()>& interrupt) {
  const std::uint64_t before = work_counted() + following_counted();
  share.stepper->set_interrupt(interrupt);
  share.report = share.stepper->advance(share.state, t_end);
  share.stepper->set_interrupt({});
  share.work = static_cast<double>(work_counted() + following_counted() - before);
}

/// The groups, those joined that could have met.
std::vector<BodyGroup> DividedStepper::joined(const std::vector<Share>& shares) const {
  std::vector<BodyGroup> groups;
  BodyRanges ranges;
  for (const Share& share : shares) {
    groups.push_back(share.bodies);
    for (const int body : share.bodies) {
      if (!model_->body(body).shapes.empty()) ranges.push_back({body, share.stepper->range(body)});
    }
  }
  return joined_where_they_meet(*model_, std::move(groups), ranges);
}

/// The State of all bodies, and what happened in the order of time.
AdvanceReport DividedStepper::put_together(const std::vector<Share>& shares, State& state) const {
  AdvanceReport report;
  State result = shares.front().state;  // Also of what is prescribed.
  result.events.contacts.clear();
  for (const Share& share : shares) {
    for (const int body : share.bodies) copy_body(share.state, result, body);
    result.events.contacts.insert(result.events.contacts.end(), share.state.events.contacts.begin(),
                                  share.state.events.contacts.end());
    report.add(share.report);
  }
  std::stable_sort(result.events.contacts.begin(), result.events.contacts.end(),
                   [&](const ContactMemory& a, const ContactMemory& b) {
                     return keeper_of(*model_, a) < keeper_of(*model_, b);
                   });
  std::stable_sort(report.events.begin(), report.events.end(),
                   [](const MotionEvent& a, const MotionEvent& b) { return a.time < b.time; });
  state = std::move(result);
  return report;
}

}  // namespace rigor
