#include "rigor/bulk/bulk_events.hpp"

#include <gtest/gtest.h>

namespace rigor::bulk_events_test {
namespace {

ManifoldMemory manifold(int a, int b, float impulse, int part = 0) {
  ManifoldMemory memory;
  memory.body_A = a;
  memory.body_B = b;
  memory.shape_A = memory.shape_B = 0;
  memory.part = part;
  memory.point_count = 2;
  memory.normal_impulse = {impulse, 0, 100, 100};  // What is behind the points does not count.
  return memory;
}

TEST(ContactEvents, BeginAndEndAreWhatIsInOneListOnly) {
  const std::vector<ManifoldMemory> before = {manifold(0, 1, 1), manifold(0, 2, 2), manifold(3, 4, 3)};
  const std::vector<ManifoldMemory> after = {manifold(0, 2, 5), manifold(1, 2, 6), manifold(4, 5, 7)};
  using Kind = ContactEvent::Kind;
  const std::vector<ContactEvent> expected = {{Kind::end, 0, 1, 0, 0, 1},
                                              {Kind::begin, 1, 2, 0, 0, 6},
                                              {Kind::end, 3, 4, 0, 0, 3},
                                              {Kind::begin, 4, 5, 0, 0, 7}};
  EXPECT_EQ(contact_events(before, after), expected);
  EXPECT_TRUE(contact_events(after, after).empty());
  EXPECT_EQ(contact_events({}, after).size(), 3u);
  EXPECT_EQ(contact_events(before, {}).size(), 3u);
}

TEST(ContactEvents, NearShapesThatDoNotPressHaveNone) {
  EXPECT_TRUE(contact_events({}, {manifold(0, 1, 0)}).empty());
  const std::vector<ContactEvent> events = contact_events({manifold(0, 1, 1)}, {manifold(0, 1, 0)});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].kind, ContactEvent::Kind::end);
}

TEST(ContactEvents, ManifoldsOfAPairCountTogether) {
  const std::vector<ContactEvent> events = contact_events({}, {manifold(0, 1, 1, 0), manifold(0, 1, 2, 5)});
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(events[0].normal_impulse, 3);
}

TEST(ContactEvents, HitsAreNewAndFastEnoughAndPress) {
  std::vector<BulkContact> contacts(4);
  for (int i = 0; i < 4; ++i) {
    BulkContact& contact = contacts[static_cast<std::size_t>(i)];
    contact.body_B = i;
    contact.point_count = 1;
    contact.points[0].normal_impulse = i == 2 ? 0 : 1;
    contact.approach_speed = i;
    contact.is_new = i != 3;
  }
  const std::vector<BulkContact> hits = find_hits(contacts, 1);
  ASSERT_EQ(hits.size(), 1u);
  EXPECT_EQ(hits[0].body_B, 1);
}

}  // namespace
}  // namespace rigor::bulk_events_test
