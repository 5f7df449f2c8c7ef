#include "rigor/bulk/threads/subnormals.hpp"

#include "rigor/bulk/bulk_world.hpp"
#include "rigor/bulk/threads/executor.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <bit>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>

namespace rigor::subnormals_test {
namespace {

/// Whether half of the least normal number is zero on this thread.
bool is_flushed() {
  volatile float least = std::numeric_limits<float>::min();
  volatile float half = 0.5F * least;
  return half == 0;
}

/// Processors that can.
bool can_flush() {
  const SubnormalScope scope(Subnormals::flushed);
  return subnormals_now() == Subnormals::flushed;
}

TEST(Subnormals, AreFlushedWithinAScopeAndKeptAfterIt) {
  if (!can_flush()) GTEST_SKIP() << "not on this processor";
  EXPECT_FALSE(is_flushed());
  {
    const SubnormalScope outer(Subnormals::flushed);
    EXPECT_TRUE(is_flushed());
    {
      const SubnormalScope inner(Subnormals::kept);
      EXPECT_FALSE(is_flushed());
    }
    EXPECT_TRUE(is_flushed());
  }
  EXPECT_FALSE(is_flushed());
  EXPECT_THROW(
      {
        const SubnormalScope scope(Subnormals::flushed);
        throw std::runtime_error("thrown within");
      },
      std::runtime_error);
  EXPECT_FALSE(is_flushed());
}

TEST(Subnormals, AreTakenByAllThreadsOfALoopAsByItsCaller) {
  if (!can_flush()) GTEST_SKIP() << "not on this processor";
  const Executor executor(4);
  const auto flushed_ranges = [&] {
    std::atomic<int> flushed = 0, ranges = 0;
    executor.for_ranges(10000, 1, [&](int, int) {
      ++ranges;
      if (is_flushed()) ++flushed;
    });
    EXPECT_TRUE(flushed == 0 || flushed == ranges);
    return flushed > 0;
  };
  for (const bool has_team : {false, true}) {
    for (const Subnormals mode : {Subnormals::flushed, Subnormals::kept}) {
      const SubnormalScope scope(mode);
      const std::unique_ptr<Executor::Team> team =
          has_team ? std::make_unique<Executor::Team>(executor) : nullptr;
      for (int k = 0; k < 20; ++k) EXPECT_EQ(flushed_ranges(), mode == Subnormals::flushed);
    }
  }
}

bool is_subnormal(float number) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(number);
  return (bits & 0x7f800000U) == 0 && (bits & 0x007fffffU) != 0;
}

TEST(Subnormals, StepsMakeNoneAndLeaveTheModeOfTheirCaller) {
  if (!can_flush()) GTEST_SKIP() << "not on this processor";
  // Damping would take twice the least normal number to a half of it and below.
  ModelBuilder builder;
  BodyDescription body;
  body.name = "ball";
  body.linear_damping = 60;
  body.velocity = Vec3(2.0 * static_cast<double>(std::numeric_limits<float>::min()), 0, 1);
  body.shapes.push_back({Sphere{0.5}, Vec3::Zero(), Quat::Identity(), "", ""});
  builder.add_body(body);
  const std::shared_ptr<const Model> model = builder.build();
  for (const Subnormals mode : {Subnormals::kept, Subnormals::flushed}) {
    const SubnormalScope scope(mode);
    BulkWorld world(model, BulkSettings{});
    world.read(make_initial_state(*model));
    for (int k = 0; k < 5; ++k) {
      world.step(1.0 / 60);
      EXPECT_FALSE(is_subnormal(world.bodies().motion[0].v[0])) << "step " << k;
    }
    EXPECT_EQ(subnormals_now(), mode);
    EXPECT_LT(world.bodies().motion[0].v[2], 0.1F);
  }
}

}  // namespace
}  // namespace rigor::subnormals_test
