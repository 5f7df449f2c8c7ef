// The progress line fits any terminal, and whatever it shows it shows whole.

#include "apps/progress.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <sstream>
#include <string>

namespace rigor::progress_test {
namespace {

std::set<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; stream >> word;) {
    if (word.back() == ',') word.pop_back();
    words.insert(word);
  }
  return words;
}

/// Every word of the line for each width stands in the widest line, too, but for the bar and the share.
template <typename Contents>
void expect_whole_words(const Contents& contents) {
  const std::set<std::string> all = words_of(progress_text(contents, 1000));
  for (int width = 1; width <= 200; ++width) {
    const std::string text = progress_text(contents, width);
    EXPECT_LE(text.size(), static_cast<std::size_t>(width)) << text;
    if (text.find('%') != std::string::npos) continue;
    for (const std::string& word : words_of(text)) {
      EXPECT_TRUE(word[0] == '[' || all.count(word)) << word << " of: " << text;
    }
  }
}

TEST(Progress, IsNeverCutInsideANumber) {
  expect_whole_words(Progress{.time = 12.3456,
                              .start = 0,
                              .end = 1234.5,
                              .elapsed = 4321,
                              .impacts = 1234567,
                              .resting = 98765,
                              .energy_drift = 3e-12,
                              .label = "run 2 of 12: ",
                              .advice = "events crowd: method.scheme=auto would be quicker"});
  expect_whole_words(Progress{
      .time = 0, .start = 0, .end = 1e-3, .elapsed = 0, .impacts = 0, .resting = 0, .energy_drift = 0});
  expect_whole_words(CuttingProgress{"gear.stl", 37, 64, 0.00123});
  expect_whole_words(CuttingProgress{"gear.stl", 1, 64, std::numeric_limits<double>::infinity()});
}

TEST(Progress, ShowsTheImportantFirst) {
  const Progress progress{
      .time = 5, .start = 0, .end = 10, .elapsed = 2, .impacts = 7, .resting = 1, .energy_drift = 0};
  EXPECT_EQ(progress_text(progress, 40), "5/10 s [###...] 2.5x real time, ETA 0:02");
  EXPECT_EQ(progress_text(progress, 6), "50 %");
  EXPECT_EQ(progress_text(progress, 79),
            "5/10 s [##...] 2.5x real time, ETA 0:02, 7 impacts, 1 at rest, energy drift 0 J");
}

TEST(Progress, LeavesOutADriftThatIsNotKnown) {
  const Progress progress{.time = 5,
                          .start = 0,
                          .end = 10,
                          .elapsed = 2,
                          .impacts = 7,
                          .resting = 1,
                          .energy_drift = std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(progress_text(progress, 64), "5/10 s [####....] 2.5x real time, ETA 0:02, 7 impacts, 1 at rest");
}

}  // namespace
}  // namespace rigor::progress_test
