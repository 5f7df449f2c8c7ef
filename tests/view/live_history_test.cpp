#include "rigor/view/live/live_history.hpp"

#include "rigor/view/live/live_run.hpp"
#include "view/live_scenes.hpp"
#include "view/page_reading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::live_history_test {
namespace {

// Places of the series that the header of a page lists.
constexpr std::size_t time_at = 0, kinetic_at = 1, penetration_at = 7, impacts_at = 9, series_count = 11;

std::vector<double> row_at(double time, double kinetic, double penetration, double impacts) {
  std::vector<double> row(series_count, 0.0);
  row[time_at] = time, row[kinetic_at] = kinetic, row[penetration_at] = penetration,
  row[impacts_at] = impacts;
  return row;
}
MotionEvent impact_at(double time, double impulse) {
  return {
      .kind = MotionEvent::Kind::impact, .time = time, .body_A = 0, .body_B = 1, .j_W = Vec3(0, 0, impulse)};
}

TEST(LiveHistory, ManyRowsAreJoinedAndKeepEndsSumsAndExtremes) {
  LiveHistory history;
  constexpr int count = 5000;
  for (int i = 0; i < count; ++i) history.add(row_at(i, 2 * i, i == 1234 ? 0.5 : 0.1, 1), {});
  const std::vector<std::vector<double>> rows = history.rows();
  EXPECT_LE(rows.size(), LiveHistory::most_rows);
  EXPECT_GE(rows.size(), LiveHistory::most_rows / 2);
  double impacts = 0, deepest = 0;
  for (const std::vector<double>& row : rows) {
    impacts += row[impacts_at];
    deepest = std::max(deepest, row[penetration_at]);
    EXPECT_EQ(row[kinetic_at], 2 * row[time_at]) << "values are those of the row's time";
  }
  EXPECT_EQ(impacts, count);
  EXPECT_EQ(deepest, 0.5);
  EXPECT_EQ(rows.back()[time_at], count - 1) << "the newest is there even where its row is not full";
  for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GT(rows[i][time_at], rows[i - 1][time_at]);
}

TEST(LiveHistory, OfManyEventsTheStrongestStay) {
  LiveHistory history;
  constexpr int count = 10000;
  for (int i = 0; i < count; ++i) {
    const MotionEvent event = impact_at(i, i == 4321 ? 9 : 1 + 1e-6 * i);
    history.add(row_at(i, 0, 0, 1), {&event, 1});
  }
  const std::vector<MotionEvent> events = history.events();
  EXPECT_LE(events.size(), LiveHistory::most_events);
  EXPECT_EQ(history.event_count(), static_cast<std::uint64_t>(count));
  EXPECT_EQ(events.back().time, count - 1) << "the newest is there";
  const auto strongest = std::max_element(
      events.begin(), events.end(), [](const auto& a, const auto& b) { return a.j_W.norm() < b.j_W.norm(); });
  EXPECT_EQ(strongest->time, 4321);
  // They cover the whole time: no gap is longer than a few times the mean one.
  for (std::size_t i = 1; i < events.size(); ++i)
    EXPECT_LE(events[i].time - events[i - 1].time, 4.0 * count / LiveHistory::most_events);
}

TEST(LiveHistory, ItsRevisionChangesWithWhatIsAddedAndCleared) {
  LiveHistory history;
  const std::uint64_t first = history.revision();
  history.add(row_at(0, 0, 0, 0), {});
  const std::uint64_t second = history.revision();
  EXPECT_NE(second, first);
  history.clear();
  EXPECT_NE(history.revision(), second);
  EXPECT_NE(history.revision(), first);
  EXPECT_TRUE(history.rows().empty());
  EXPECT_TRUE(history.events().empty());
}

TEST(LiveHistory, ItsMessageHoldsRowsAndEvents) {
  LiveHistory history;
  const MotionEvent event{.kind = MotionEvent::Kind::separation,
                          .time = 0.25,
                          .body_A = 3,
                          .body_B = 4,
                          .p_W = Vec3(1, 2, 3),
                          .j_W = Vec3(4, 5, 6)};
  history.add(row_at(0.5, 8, 0, 1), {&event, 1});
  test::BytesReader bytes(live_history_bytes(history, 7, Vec3(1, 1, 1)));
  EXPECT_EQ(bytes.take<std::uint32_t>(), 3u);  // kind
  EXPECT_EQ(bytes.take<std::uint32_t>(), 7u);  // generation
  EXPECT_EQ(bytes.take<std::uint32_t>(), series_count);
  EXPECT_EQ(bytes.take<std::uint32_t>(), 1u);  // rows
  EXPECT_EQ(bytes.take<std::uint32_t>(), 1u);  // events
  EXPECT_EQ(bytes.take<double>(), 1);          // events so far
  for (const double value : row_at(0.5, 8, 0, 1)) EXPECT_EQ(bytes.take<double>(), value);
  EXPECT_EQ(bytes.take<double>(), 0.25);
  EXPECT_EQ(bytes.take<std::uint32_t>(), 2u);
  EXPECT_EQ(bytes.take<std::uint32_t>(), 3u);
  EXPECT_EQ(bytes.take<std::uint32_t>(), 4u);
  for (const float x : {0.0F, 1.0F, 2.0F, 4.0F, 5.0F, 6.0F}) EXPECT_EQ(bytes.take<float>(), x);
}

TEST(LiveHistory, OfALiveRunHoldsItsImpactsAndBeginsAnewWithAReset) {
  LiveRun run(test::live_scene());
  while (run.time() < 0.5 - 1e-9) run.step();
  const std::vector<MotionEvent> events = run.history().events();
  ASSERT_FALSE(events.empty());
  // It falls 0.9 m under 10 m/s² and bounces with 0.5: m (1 + e) v.
  const double fall = std::sqrt(2 * 0.9 / 10);
  EXPECT_NEAR(events[0].time, fall, 1e-9);
  EXPECT_NEAR(events[0].j_W.norm(), 1.5 * 10 * fall, 1e-9);
  EXPECT_EQ(run.history().rows().size(), 51u);
  run.reset();
  EXPECT_TRUE(run.history().events().empty());
  EXPECT_EQ(run.history().rows().size(), 1u);
}

}  // namespace
}  // namespace rigor::live_history_test
