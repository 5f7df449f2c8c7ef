// Rows that memory does not hold lie in a file, and are read back as they were.

#include "studies.hpp"

#include "random_vectors.hpp"
#include "rigor/core/input_error.hpp"
#include "rigor/io/files/file_error.hpp"
#include "rigor/study/kinds/statistics.hpp"
#include "rigor/study/run/audit_quantity.hpp"
#include "rigor/study/workers/row_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rigor::row_table_test {
namespace {

constexpr std::size_t columns = 200;  // Blocks of 1.6 MB, of which two are kept.

RunRow row_of(std::uint64_t run) {
  RunRow row{
      run, run % 7 == 3 ? RunStatus::stopped : RunStatus::done, 1e-3 * static_cast<double>(run), {}, {}};
  for (std::size_t k = 0; k < columns; ++k)
    row.outcomes.push_back(static_cast<double>(run) + 1e-3 * static_cast<double>(k));
  if (run % 7 == 3) row.reason = "run " + std::to_string(run);
  return row;
}

void expect_row(const RowTable& table, std::uint64_t run) {
  const RunRow row = row_of(run);
  ASSERT_TRUE(table.has(run));
  EXPECT_EQ(table.status(run), row.status);
  EXPECT_EQ(table.reason(run), row.reason);
  EXPECT_EQ(table.cpu_time(run), static_cast<double>(static_cast<float>(row.cpu_time)));
  for (const std::size_t k : {std::size_t{0}, columns / 2, columns - 1})
    EXPECT_EQ(table.value(run, k), row.outcomes[k]);
}

TEST(RowTable, GivesBackWhatItHasPutAway) {
  constexpr std::uint64_t runs = 7000;
  const std::filesystem::path folder = testing::TempDir() + "rigor_rows";
  std::filesystem::create_directories(folder);
  RowTable table(columns);
  table.set_folder(folder);
  // In an order as threads deliver them: mixed up among neighbours.
  std::vector<std::uint64_t> order(runs);
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  std::mt19937 random(1);
  for (std::uint64_t i = 0; i + 40 < runs; i += 40)
    std::shuffle(order.begin() + static_cast<long>(i), order.begin() + static_cast<long>(i + 40), random);
  for (const std::uint64_t run : order) EXPECT_TRUE(table.enter(row_of(run)));
  EXPECT_EQ(table.prefix(), runs);
  EXPECT_EQ(table.count(), runs);
  EXPECT_FALSE(table.enter(row_of(5)));
  EXPECT_FALSE(table.has(runs));
  for (std::uint64_t run = 0; run < runs; run += 13) expect_row(table, run);
  for (int i = 0; i < 200; ++i) expect_row(table, random() % runs);
  // The file has no name: nothing is left behind, however the process ends.
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  std::filesystem::remove(folder);
}

TEST(RowTable, SaysWhereItHasNoRoom) {
  RowTable table(columns);
  table.set_folder(testing::TempDir() + "no_such_folder");
  const auto fill = [&] {
    for (std::uint64_t run = 0; run < 7000; ++run) table.enter(row_of(run));
  };
  EXPECT_THROW(fill(), FileError);
}

TEST(Statistics, SummariesAreThoseOfTheSortedValues) {
  test::Random random(4);
  for (int draw = 0; draw < 40; ++draw) {
    std::vector<double> values;
    const int n = 1 + draw * 7;
    for (int i = 0; i < n; ++i) {
      const double magnitude = std::pow(10, random.uniform(-200, 200));
      values.push_back(draw % 3 == 0 ? std::round(random.uniform(-3, 3)) : random.uniform(-1, 1) * magnitude);
    }
    if (draw % 5 == 4) values.push_back(INFINITY);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const SampleSummary summary = sample_summary(sample_of(values));
    EXPECT_EQ(summary.count, values.size());
    EXPECT_EQ(summary.smallest, sorted.front());
    EXPECT_EQ(summary.largest, sorted.back());
    EXPECT_EQ(summary.median, quantile(sorted, 0.5));
    EXPECT_EQ(summary.is_finite, draw % 5 != 4);
  }
}

TEST(AuditQuantities, AreAllNumbersOfTheAudit) {
  const auto study = studies::finished(R"yaml(rigor_study: 1
scene: ../ramp_slide.yaml
kind: sweep
set:
  run: {duration: 1, step: 0.01, output_interval: 0.5}
  expect: []
parameters:
  - {name: v, values: [1.5]}
assign:
  bodies.block.velocity: [v, 0, 0]
outcomes:
  - {name: short, value: audit.friction_loss}
  - {name: long, value: audit.energy.friction_loss}
  - {name: gone, value: audit.energy.initial - audit.energy.final + audit.energy.work - audit.dissipated}
  - {name: x, value: audit.bodies.block.position.0 - body.block.position.x}
  - {name: complete, value: audit.complete}
  - {name: residual, value: audit.solver.max_residual}
  - {name: when, value: "audit.penetration.time"}
)yaml");
  const auto value = [&](const char* name) { return studies::finding_of(*study, name).value; };
  EXPECT_GT(value("long"), 0.1);
  EXPECT_EQ(value("short"), value("long"));
  EXPECT_NEAR(value("gone"), 0, 1e-12);
  EXPECT_EQ(value("x"), 0);
  EXPECT_EQ(value("complete"), 1);
  EXPECT_GE(value("residual"), 0);
  EXPECT_EQ(study->rows().status(0), RunStatus::done);
  // Names of the audit that the scene does not have are told before anything runs.
  EXPECT_THROW(studies::finished("rigor_study: 1\nscene: ../ramp_slide.yaml\nkind: sweep\n"
                                 "parameters: [{name: v, values: [1]}]\n"
                                 "outcomes: [{name: a, value: audit.energy.lost}]\n"),
               InputError);
}

// Short names and paths tell the same in one row, also where energy is not judged.
TEST(AuditQuantities, OfTheBalanceAreNotKnownWhereTheWorkIsNot) {
  Audit audit;
  audit.dissipated = 1, audit.max_increase = 2;
  audit.report.work = 3, audit.report.motor_work = 4, audit.report.friction_loss = 5;
  audit.spans = {{{.scheme = Scheme::event_driven, .end = 1, .rise = 6}, 7, 8, 9, 10}};
  const auto value = [&](const char* name) { return audit_quantity(audit, name); };
  for (const bool knows_work : {true, false}) {
    audit.knows_work = knows_work;
    for (const auto& [name, known] : {std::pair{"dissipated", 1.0},
                                      {"energy.dissipated", 1.0},
                                      {"max_increase", 2.0},
                                      {"energy.max_increase", 2.0},
                                      {"work", 3.0},
                                      {"energy.work", 3.0},
                                      {"energy.motor_work", 4.0},
                                      {"spans.0.energy_increase.max", 6.0},
                                      {"spans.0.energy_increase.tolerance", 7.0}}) {
      if (knows_work) {
        EXPECT_EQ(value(name), known) << name;
      } else {
        EXPECT_TRUE(std::isnan(value(name))) << name;
      }
    }
    // What needs no balance is known in any case.
    EXPECT_EQ(value("friction_loss"), 5);
    EXPECT_EQ(value("energy.friction_loss"), 5);
    EXPECT_EQ(value("spans.0.penetration_tolerance"), 8);
  }
}

}  // namespace
}  // namespace rigor::row_table_test
