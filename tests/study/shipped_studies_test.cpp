#include "studies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigor::shipped_studies_test {
namespace {

/// A study of scenes/studies, and what makes it short where it takes long.
struct Shipped {
  const char* name;
  std::vector<std::pair<std::string, std::string>> changes;
};

void PrintTo(const Shipped& shipped, std::ostream* stream) {
  *stream << shipped.name;
}

std::string text_of(const Shipped& shipped) {
  std::ifstream file(std::filesystem::path(RIGOR_SOURCE_DIR) / "scenes" / "studies" /
                     (shipped.name + std::string(".yaml")));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [from, to] : shipped.changes) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the study has no longer the text " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

/// What is expected at one of the spacings of domino_wave.
std::string lost_speed(int i) {
  constexpr std::array speeds = {"1.018604547855", "1.126384928170", "1.146805325280", "1.134863101820",
                                 "1.111039985511"};
  return "  - {finding: \"speed[" + std::to_string(i) + "]\", value: " + speeds[static_cast<std::size_t>(i)] +
         ", tolerance: 1.0e-8}\n";
}

class ShippedStudy : public testing::TestWithParam<Shipped> {};

TEST_P(ShippedStudy, FindsItsNumberAndWouldNotFindAnother) {
  const auto study = studies::finished(text_of(GetParam()), 2);
  const StudyAnswer answer = study->answer();
  ASSERT_FALSE(study->plan().expected.empty());
  for (const std::string& message : unmet_expectations(study->plan(), answer)) ADD_FAILURE() << message;
  for (std::uint64_t run = 0; run < study->run_count(); ++run)
    EXPECT_EQ(study->rows().status(run), RunStatus::done) << run << ": " << study->rows().reason(run);
  StudyPlan other = study->plan();
  for (ExpectedFinding& expected : other.expected) expected.value += 1;
  EXPECT_EQ(unmet_expectations(other, answer).size(), other.expected.size());
}

// The least parts of the long ones that have the number: one spacing until the first strike, and 60 throws of
// the cube.
INSTANTIATE_TEST_SUITE_P(All, ShippedStudy,
                         testing::Values(Shipped{"slide_distance", {}}, Shipped{"impact_restitution", {}},
                                         Shipped{"arch_friction", {}}, Shipped{"arch_thickness", {}},
                                         Shipped{"break_spread", {}},
                                         Shipped{"domino_speed",
                                                 {{"[0.02, 0.025, 0.03, 0.035, 0.04]", "[0.03]"},
                                                  {"duration: 1.3", "duration: 0.08"},
                                                  {"strike[2]", "strike"}}},
                                         Shipped{"domino_wave",
                                                 {{"[0.02, 0.025, 0.03, 0.035, 0.04]", "[0.03]"},
                                                  {"speed[2]", "speed"},
                                                  {lost_speed(0), ""},
                                                  {lost_speed(1), ""},
                                                  {lost_speed(3), ""},
                                                  {lost_speed(4), ""}}},
                                         Shipped{"die_fairness",
                                                 {{"[0.12, 0.16, 0.2, 0.24, 0.28]", "[0.2]"},
                                                  {"repeats: 400", "repeats: 60"},
                                                  {"square[2]", "square"}}}),
                         [](const testing::TestParamInfo<Shipped>& parameter) {
                           return std::string(parameter.param.name);
                         });

TEST(ShippedStudies, AreAllTested) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(RIGOR_SOURCE_DIR) / "scenes" / "studies")) {
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.find("rigor_study:") != std::string::npos) ++count;
  }
  EXPECT_EQ(count, 8u) << "a study is not in the list above";
}

}  // namespace
}  // namespace rigor::shipped_studies_test
