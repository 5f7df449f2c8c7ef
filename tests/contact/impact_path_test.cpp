#include "rigor/contact/impact/impact_path.hpp"

#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rigor::impact_path_test {
namespace {

/// States of an impact path without repetition: c, r (compressing or not) and s, k (sliding or not).
std::string states_of(const std::vector<ImpactPathPoint>& points) {
  std::string states;
  for (const ImpactPathPoint& point : points) {
    const std::string state = {point.is_compressing ? 'c' : 'r', point.is_sliding ? 's' : 'k', ' '};
    if (!states.ends_with(state)) states += state;
  }
  return states;
}

TEST(ImpactPath, OfEveryReferenceImpactSaysWhatItsPhasesSay) {
  for (const nlohmann::json& json : reference::read("impact.json")["cases"]) {
    const Collision collision{{reference::matrix(json["K"]), json["mu"].get<double>()},
                              reference::vector(json["u"]),
                              json["e"].get<double>()};
    std::vector<CollisionPoint> path;
    const CollisionOutcome outcome = resolve_collision(collision, RestitutionLaw::stronge, &path);
    const std::vector<ImpactPathPoint> points = impact_path_of(path, outcome);
    SCOPED_TRACE(json["id"].get<std::string>() + " " + outcome.phases);
    std::string expected;
    bool compresses = true, slides = false;
    for (const char phase : outcome.phases) {
      if (phase == '|') compresses = false;
      if (phase == 'r') compresses = true;
      if (phase != '|' && phase != 'r') slides = phase != 'K';
      const std::string state = {compresses ? 'c' : 'r', slides ? 's' : 'k', ' '};
      // Nothing of restitution is left after the letter that e = 0 ends with.
      const bool is_over = phase == '|' && collision.restitution == 0;
      if (!is_over && !expected.ends_with(state)) expected += state;
    }
    EXPECT_EQ(states_of(points), expected);
    // The point of greatest compression is one of the path.
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const ImpactPathPoint& point) {
      return point.at.lambda.z() == outcome.compression.lambda.z();
    }));
    EXPECT_TRUE(
        std::is_sorted(points.begin(), points.end(), [](const ImpactPathPoint& a, const ImpactPathPoint& b) {
          return a.at.lambda.z() < b.at.lambda.z();
        }));
  }
}

TEST(ImpactPath, OfACompliantImpactHasTheSlipOfItsSurfaces) {
  // A reference case: slides, sticks, slides back after the greatest compression.
  const Collision collision{{Vec3(3.5, 3.5, 1).asDiagonal(), 0.3}, {0.8, 0, -1}, 1};
  std::vector<CollisionPoint> path;
  const CompliantOutcome outcome = resolve_compliant_collision({collision, 1 / 1.21}, &path);
  EXPECT_EQ(phase_letters(outcome), "SK|B");
  EXPECT_EQ(states_of(impact_path_of(path, outcome)), "cs ck rk rs ");
  EXPECT_EQ(phases_in_words("SK|B"), "slides, sticks, greatest compression, slides back");
}

TEST(ImpactPath, PhasesInWordsKnowEveryLetter) {
  EXPECT_EQ(phases_in_words("SU|SrS|;K"),
            "slides, starts to slip from rest, greatest compression, slides, compresses again, slides, "
            "greatest compression, the law ends while the bodies approach, a new impact begins, sticks");
  EXPECT_EQ(phases_in_words(""), "nothing: the bodies do not approach");
}

TEST(ImpactPath, ConditionAndRemovableEnergyAreThoseOfK) {
  const Mat3 axes = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Mat3 K = axes * Vec3(8, 2, 0.5).asDiagonal() * axes.transpose();
  EXPECT_NEAR(condition_number(K), 16, 1e-13);
  const Vec3 u = axes * Vec3(2, 4, 3);
  EXPECT_NEAR(removable_energy(K, u), 0.5 * (4.0 / 8 + 16.0 / 2 + 9 / 0.5), 1e-13);
  const Mat3 flat = Vec3(1, 0, 1).asDiagonal();
  EXPECT_TRUE(std::isinf(condition_number(flat)));
  EXPECT_TRUE(std::isinf(removable_energy(flat, u)));
}

}  // namespace
}  // namespace rigor::impact_path_test
