#include "rigor/sim/time_stepping/impact_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <thread>
#include <vector>

namespace rigor::impact_memory_test {
namespace {

Contact contact_at(double x) {
  Contact contact{
      .body_A = 0, .body_B = 1, .shape_A = 0, .shape_B = 0, .point = {}, .friction = 0.5, .restitution = 0.3};
  contact.point.p_WA = contact.point.p_WB = Vec3(x, 0, 0);
  contact.point.n_W = Vec3::UnitZ();
  contact.point.gap = 0;
  return contact;
}

Cluster two_bodies() {
  Cluster part;
  part.bodies = {1, 2};
  part.phases.resize(2);
  for (BodyPhase& phase : part.phases) {
    phase.x = Vec3(1, 2, 3);
    phase.q = Quat::Identity();
    phase.P = Vec3(0, 0, -1);
    phase.L = Vec3(0.1, 0.2, 0.3);
  }
  part.contacts = {contact_at(0), contact_at(1)};
  return part;
}

/// An impact that turns all momenta round and counts how often it is asked for.
struct Bounce {
  int calls = 0;
  void operator()(Cluster& part, AdvanceReport& report) {
    ++calls;
    for (BodyPhase& phase : part.phases) phase.P = -0.3 * phase.P;
    report.impacts += 2;
    report.impact_loss += 0.25;
  }
};

TEST(ImpactMemory, GivesTheSameAnswerAndReportAgain) {
  ImpactMemory memory;
  Bounce bounce;
  AdvanceReport report;
  for (int k = 1; k <= 3; ++k) {
    Cluster part = two_bodies();
    memory.collide(part, std::ref(bounce), report);
    EXPECT_EQ(bounce.calls, 1);
    EXPECT_EQ(report.impacts, 2 * k);
    EXPECT_EQ(report.impact_loss, 0.25 * k);
    for (const BodyPhase& phase : part.phases) EXPECT_EQ(phase.P, -0.3 * Vec3(0, 0, -1));
  }
}

/// What differs in the last bit is another impact.
TEST(ImpactMemory, TellsImpactsApartByTheirLastBit) {
  const auto next = [](double& x) { x = std::nextafter(x, std::numeric_limits<double>::infinity()); };
  const std::vector<std::function<void(Cluster&)>> changes{
      [&](Cluster& part) { next(part.phases[1].x.y()); },
      [&](Cluster& part) { next(part.phases[0].P.z()); },
      [&](Cluster& part) { next(part.phases[1].L.x()); },
      [&](Cluster& part) { next(part.phases[0].q.coeffs().x()); },
      [&](Cluster& part) { next(part.contacts[1].point.gap); },
      [&](Cluster& part) { next(part.contacts[0].point.p_WB.x()); },
      [&](Cluster& part) { next(part.contacts[1].point.n_W.x()); },
      [&](Cluster& part) { part.contacts.pop_back(); },
      [&](Cluster& part) { part.contacts[0].shape_B = 1; },
      [&](Cluster& part) { part.bodies[1] = 3; }};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    ImpactMemory memory;
    Bounce bounce;
    AdvanceReport report;
    Cluster first = two_bodies(), other = two_bodies(), again = two_bodies();
    changes[k](other);
    memory.collide(first, std::ref(bounce), report);
    memory.collide(other, std::ref(bounce), report);
    EXPECT_EQ(bounce.calls, 2) << k;
    memory.collide(again, std::ref(bounce), report);
    EXPECT_EQ(bounce.calls, 2) << k;
  }
}

TEST(ImpactMemory, ForgetsWhatWasInAnotherStep) {
  ImpactMemory memory;
  Bounce bounce;
  AdvanceReport report;
  for (int k = 1; k <= 2; ++k) {
    Cluster part = two_bodies();
    memory.collide(part, std::ref(bounce), report);
    EXPECT_EQ(bounce.calls, k);
    memory.clear();
  }
}

/// Parts of two threads, with some impacts in common: each gets what it would get alone.
TEST(ImpactMemory, ServesSeveralThreads) {
  ImpactMemory memory;
  std::vector<AdvanceReport> reports(2);
  std::vector<int> wrong(2, 0);
  const auto run = [&](std::size_t thread) {
    for (int k = 0; k < 200; ++k) {
      Cluster part = two_bodies();
      part.phases[0].P.x() = k % 50;
      memory.collide(part, Bounce(), reports[thread]);
      wrong[thread] += part.phases[0].P.x() != -0.3 * (k % 50);
    }
  };
  std::thread other(run, 1);
  run(0);
  other.join();
  for (const std::size_t thread : {0, 1}) {
    EXPECT_EQ(wrong[thread], 0);
    EXPECT_EQ(reports[thread].impacts, 400);
  }
}

}  // namespace
}  // namespace rigor::impact_memory_test
