#include "rigor/sim/event_driven/event_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace rigor::event_queue_test {
namespace {

using Kind = QueuedEvent::Kind;

std::vector<QueuedEvent> many_events() {
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> small(0, 3);
  std::vector<QueuedEvent> events;
  // Few times and bodies: many ties.
  for (int i = 0; i < 500; ++i) {
    const auto kind = static_cast<Kind>(small(generator) % 3);
    const double time = 0.25 * small(generator);
    const int a = small(generator), b = 4 + small(generator);
    events.push_back({time, kind, a, b, 0, 0, 0});
  }
  return events;
}

std::vector<QueuedEvent> drained(EventQueue& queue) {
  std::vector<QueuedEvent> events;
  for (; !queue.is_empty(); queue.pop()) events.push_back(queue.first());
  return events;
}

bool same(const QueuedEvent& x, const QueuedEvent& y) {
  return !x.is_before(y) && !y.is_before(x);
}

TEST(EventQueue, GivesEventsInTheirTotalOrderHoweverItWasFilled) {
  std::vector<QueuedEvent> events = many_events();
  std::vector<QueuedEvent> sorted = events;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& x, const auto& y) { return x.is_before(y); });
  std::mt19937 generator(6);
  for (int trial = 0; trial < 5; ++trial) {
    std::shuffle(events.begin(), events.end(), generator);
    EventQueue queue;
    for (const QueuedEvent& event : events) queue.push(event);
    EXPECT_EQ(queue.size(), events.size());
    EXPECT_TRUE(std::ranges::equal(drained(queue), sorted, same));
  }
}

TEST(EventQueue, OfOneTimeWindowsEndFirstThenStepsThenContacts) {
  EventQueue queue;
  queue.push({1, Kind::window_end, 0, -1, 0, 0, 0});
  queue.push({1, Kind::contact, 2, 3, 0, 0, 0});
  queue.push({1, Kind::contact, 1, 3, 0, 0, 0});
  queue.push({1, Kind::step_end, 9, -1, 0, 0, 0});
  const std::vector<QueuedEvent> events = drained(queue);
  EXPECT_EQ(events[0].kind, Kind::window_end);
  EXPECT_EQ(events[1].kind, Kind::step_end);
  EXPECT_EQ(events[2].a, 1);
  EXPECT_EQ(events[3].a, 2);
}

TEST(EventQueue, DroppingKeepsTheOrderOfTheOthers) {
  const std::vector<QueuedEvent> events = many_events();
  EventQueue dropped, kept;
  for (const QueuedEvent& event : events) {
    dropped.push(event);
    if (event.a != 2) kept.push(event);
  }
  dropped.drop_if([](const QueuedEvent& event) { return event.a == 2; });
  EXPECT_TRUE(std::ranges::equal(drained(dropped), drained(kept), same));
}

}  // namespace
}  // namespace rigor::event_queue_test
