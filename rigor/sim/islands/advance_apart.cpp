#include "rigor/sim/islands/advance_apart.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/core/work_count.hpp"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

/// Which of the bodies the memory of a contact is kept with: the order in which one stepper would list them.
int keeper_of(const Model& model, const ContactMemory& contact) {
  return model.body(contact.body_B).motion == MotionType::dynamic ? contact.body_B : contact.body_A;
}

void copy_body(const State& from, State& to, int body) {
  const auto copy = [body](const std::vector<double>& of_from, std::vector<double>& of_to, int size) {
    std::copy_n(of_from.begin() + size * body, size, of_to.begin() + size * body);
  };
  copy(from.x, to.x, 3);
  copy(from.q, to.q, 4);
  copy(from.P, to.P, 3);
  copy(from.L, to.L, 3);
  copy(from.epoch, to.epoch, 1);
  copy(from.anchor, to.anchor, 13);
}

/// The State as a group sees it: contacts of others are none of its memory.
State seen_by(const BodyGroup& bodies, const State& state) {
  State seen = state;
  std::vector<bool> is_here(at(state.body_count()));
  for (const int body : bodies) is_here[at(body)] = true;
  std::erase_if(seen.events.contacts, [&](const ContactMemory& contact) {
    return !is_here[at(contact.body_A)] && !is_here[at(contact.body_B)];
  });
  return seen;
}

/// Advances groups from the first on, on the threads.
void advance_all(std::vector<ApartGroup>& groups, std::size_t first, const Executor& executor,
                 std::vector<double>& work_of_bodies, const ApartWork& work) {
  // Those that took long before begin first, so that the threads end together; whoever is free takes the next
  // one.
  std::vector<double> foreseen(groups.size());
  for (std::size_t i = first; i < groups.size(); ++i) {
    for (const int body : groups[i].bodies) foreseen[i] += 1 + work_of_bodies[at(body)];
  }
  std::vector<std::size_t> order(groups.size() - first);
  std::iota(order.begin(), order.end(), first);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return foreseen[a] > foreseen[b]; });
  const std::function<bool()> interrupt = shared_interrupt();
  std::atomic<std::size_t> next{0};
  executor.for_ranges(executor.threads(), 1, [&](int, int) {
    const InterruptScope scope(interrupt);
    for (std::size_t i = next++; i < order.size(); i = next++) {
      ApartGroup& group = groups[order[i]];
      const std::uint64_t before = work_counted() + following_counted();
      work.advance(group);
      group.work = static_cast<double>(work_counted() + following_counted() - before);
    }
  });
  for (std::size_t i = first; i < groups.size(); ++i) {
    for (const int body : groups[i].bodies)
      work_of_bodies[at(body)] = groups[i].work / static_cast<double>(groups[i].bodies.size());
  }
}

/// The groups, those joined that could have met.
std::vector<BodyGroup> joined(const Model& model, const std::vector<ApartGroup>& groups) {
  std::vector<BodyGroup> result;
  BodyRanges ranges;
  for (const ApartGroup& group : groups) {
    result.push_back(group.bodies);
    ranges.insert(ranges.end(), group.ranges.begin(), group.ranges.end());
  }
  return joined_where_they_meet(model, std::move(result), ranges);
}

}  // namespace

StopReason reason_of(const std::vector<ApartGroup>& groups) {
  StopReason reason = StopReason::reached_end;
  for (const ApartGroup& group : groups) {
    if (group.report.reason != StopReason::reached_end && reason != StopReason::interrupted)
      reason = group.report.reason;
  }
  return reason;
}

std::vector<ApartGroup> advance_apart(const Model& model, const Executor& executor,
                                      std::vector<BodyGroup> groups, const State& state,
                                      std::vector<double>& work_of_bodies, const ApartWork& work) {
  std::vector<ApartGroup> advanced;
  while (groups.size() > 1) {
    const std::size_t first = advanced.size();
    for (BodyGroup& bodies : groups) {
      const bool is_known = std::any_of(advanced.begin(), advanced.end(),
                                        [&](const ApartGroup& group) { return group.bodies == bodies; });
      if (is_known) continue;
      work.begin(bodies);
      State seen = seen_by(bodies, state);
      advanced.push_back({std::move(bodies), std::move(seen), {}});
    }
    advance_all(advanced, first, executor, work_of_bodies, work);
    if (reason_of(advanced) != StopReason::reached_end) return advanced;

    // Those that could have met, as one.
    groups = joined(model, advanced);
    if (groups.size() == advanced.size()) return advanced;
    std::erase_if(advanced, [&](const ApartGroup& group) {
      return std::find(groups.begin(), groups.end(), group.bodies) == groups.end();
    });
  }
  return {};
}

AdvanceReport put_together(const Model& model, const std::vector<ApartGroup>& groups, State& state) {
  AdvanceReport report;
  State result = groups.front().state;  // Also of what is prescribed.
  std::vector<ContactMemory>& contacts = result.events.contacts;
  contacts.clear();
  for (const ApartGroup& group : groups) {
    for (const int body : group.bodies) copy_body(group.state, result, body);
    contacts.insert(contacts.end(), group.state.events.contacts.begin(), group.state.events.contacts.end());
    report.add(group.report);
  }
  std::stable_sort(contacts.begin(), contacts.end(), [&](const ContactMemory& a, const ContactMemory& b) {
    return keeper_of(model, a) < keeper_of(model, b);
  });
  std::stable_sort(report.events.begin(), report.events.end(),
                   [](const MotionEvent& a, const MotionEvent& b) { return a.time < b.time; });
  state = std::move(result);
  return report;
}

}  // namespace rigor
