#include "studies.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Every kind of study against closed forms, on functions drawn at random.
namespace rigor::random_functions_test {
namespace {

using studies::finding_of;
using studies::finished;

/// Numbers for the functions; fixed, so that the test is the same each time.
class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int whole(int low, int high) { return low + static_cast<int>(between(0, 1) * (high - low + 1)); }

 private:
  std::mt19937 engine_;
};

std::string head(const std::string& kind, const std::string& more) {
  return "rigor_study: 1\nkind: " + kind + "\n" + more + "parameters:\n";
}
std::string outcome(const std::string& formula) {
  return "outcomes:\n  - {name: y, formula: \"" + formula + "\"}\n";
}

// Sobol's function: the product of (|4 x_i - 2| + a_i) / (1 + a_i), of partial variances 1 / (3 (1 + a_i)²).
// Saltelli and Sobol', Reliability Engineering and System Safety 50, 1995.
TEST(RandomFunctions, IntervalsOfSobolIndicesHoldTheTruth) {
  Draw draw(1);
  int held = 0, all = 0;
  for (int function = 0; function < 12; ++function) {
    const int n = draw.whole(2, 5);
    std::string text = head("sensitivity", fmt::format("runs: 512\nseed: {}\n", function + 1)), formula = "1";
    std::vector<double> partial;
    double variance = 1;
    for (int i = 0; i < n; ++i) {
      const double a = draw.between(0, 5), low = draw.between(-3, 3), width = draw.between(0.1, 4);
      text += fmt::format("  - {{name: x{}, range: [{:.17g}, {:.17g}]}}\n", i, low, low + width);
      formula += fmt::format(" * (abs(4 * (x{0} - {1:.17g}) / {2:.17g} - 2) + {3:.17g}) / {4:.17g}", i, low,
                             width, a, 1 + a);
      partial.push_back(1 / (3 * (1 + a) * (1 + a)));
      variance *= 1 + partial.back();
    }
    const auto study = finished(text + outcome(formula));
    for (int i = 0; i < n; ++i) {
      const double own = partial[static_cast<std::size_t>(i)];
      const std::vector<std::pair<std::string, double>> truths = {
          {fmt::format("y.first.x{}", i), own / (variance - 1)},
          {fmt::format("y.total.x{}", i), own * variance / (1 + own) / (variance - 1)}};
      for (const auto& [name, truth] : truths) {
        const Finding found = finding_of(*study, name);
        // Four half widths of a 95 % interval are eight standard deviations.
        EXPECT_NEAR(found.value, truth, 4 * 0.5 * (*found.high - *found.low) + 1e-12)
            << name << " of " << formula;
        held += *found.low <= truth && truth <= *found.high ? 1 : 0;
        ++all;
      }
    }
  }
  // Points of Sobol's sequence err less than the independent ones that the bootstrap takes them for: at least
  // 95 %.
  EXPECT_GE(held, static_cast<int>(0.93 * all)) << all;
}

// The mean of a random polynomial of independent parameters of any distribution: products of known moments.
TEST(RandomFunctions, IntervalsOfMeansHoldTheTruth) {
  Draw draw(2);
  int held = 0;
  constexpr int functions = 150;
  for (int function = 0; function < functions; ++function) {
    const double a = draw.between(-2, 2), b = draw.between(0.1, 3), m = draw.between(-2, 2),
                 s = draw.between(0.1, 2), lm = draw.between(-1, 1), ls = draw.between(0.1, 0.5),
                 r = draw.between(0.1, 3);
    const double c = draw.between(-1, 1), d = draw.between(-1, 1), e = draw.between(-1, 1),
                 f = draw.between(-1, 1);
    const std::string text =
        head("monte-carlo", fmt::format("runs: 200\nseed: {}\n", function + 1)) +
        fmt::format(
            "  - {{name: u, range: [{:.17g}, {:.17g}]}}\n"
            "  - {{name: n, distribution: normal, mean: {:.17g}, deviation: {:.17g}}}\n"
            "  - {{name: l, distribution: lognormal, mean: {:.17g}, deviation: {:.17g}}}\n"
            "  - {{name: p, distribution: sphere, radius: {:.17g}}}\n"
            "  - {{name: w, formula: \"u + n\"}}\n",
            a, a + b, m, s, lm, ls, r);
    // A formula of outcomes has no names with points: those of the sphere come in by a parameter of its own.
    const std::string with_sphere =
        text + "  - {name: z2, formula: \"p.z^2\"}\n" +
        outcome(fmt::format("{:.17g} * w^2 + {:.17g} * u * n + {:.17g} * l + {:.17g} * z2", c, d, e, f));
    const double mean_u = a + b / 2, mean_u2 = b * b / 12 + mean_u * mean_u, mean_n2 = m * m + s * s;
    const double truth = c * (mean_u2 + 2 * mean_u * m + mean_n2) + d * mean_u * m +
                         e * std::exp(lm + ls * ls / 2) + f * r * r / 3;
    const Finding y = finding_of(*finished(with_sphere), "y");
    EXPECT_NEAR(y.value, truth, 4 * 0.5 * (*y.high - *y.low));
    held += *y.low <= truth && truth <= *y.high ? 1 : 0;
  }
  // 142.5 are expected, with a standard deviation of 2.7; the lognormal's tail costs a little.
  EXPECT_GE(held, 132);
  EXPECT_LT(held, functions);
}

// Of Σ b_i u_i + Σ c_ij u_i u_j with positive numbers the effect of u_i is b_i + Σ c_ij u_j, and each u_j is
// uniform on the grid of p levels: mean 1/2, variance (p + 1) / (12 (p - 1)).
TEST(RandomFunctions, MorrisFindsMeanAndDeviationOfEffects) {
  Draw draw(3);
  for (int function = 0; function < 10; ++function) {
    const int n = draw.whole(2, 5), levels = 2 * draw.whole(2, 5);
    std::string text = head("morris", fmt::format("runs: 400\nseed: {}\nlevels: {}\n", function + 1, levels)),
                formula = "0";
    std::vector<std::vector<double>> c(static_cast<std::size_t>(n),
                                       std::vector<double>(static_cast<std::size_t>(n)));
    std::vector<double> b;
    for (std::size_t i = 0; i < c.size(); ++i) {
      b.push_back(draw.between(0, 3));
      text += fmt::format("  - {{name: u{}, range: [0, 1]}}\n", i);
      formula += fmt::format(" + {:.17g} * u{}", b.back(), i);
      for (std::size_t j = 0; j < i; ++j) {
        c[i][j] = c[j][i] = draw.between(0, 2);
        formula += fmt::format(" + {:.17g} * u{} * u{}", c[i][j], i, j);
      }
    }
    const auto study = finished(text + outcome(formula));
    const double level_variance = (levels + 1.0) / (12.0 * (levels - 1));
    for (std::size_t i = 0; i < c.size(); ++i) {
      double mean = b[i], variance = 0;
      for (const double cij : c[i]) mean += cij / 2, variance += cij * cij * level_variance;
      const double deviation = std::sqrt(variance), error = deviation / std::sqrt(400.0);
      EXPECT_NEAR(finding_of(*study, fmt::format("y.size.u{}", i)).value, mean, 5 * error + 1e-12);
      EXPECT_NEAR(finding_of(*study, fmt::format("y.deviation.u{}", i)).value, deviation, 5 * error + 1e-9);
    }
  }
}

// Thresholds of random powers, on ranges and logarithmic ranges, from below and from above.
TEST(RandomFunctions, BisectionEndsAtTheRootWithinItsTolerance) {
  Draw draw(4);
  for (int function = 0; function < 200; ++function) {
    const double low = std::pow(10, draw.between(-4, 0)), high = low * draw.between(1.5, 1e4);
    const double root = low + draw.between(0.001, 0.999) * (high - low), power = draw.between(0.3, 4);
    const double tolerance = (high - low) * std::pow(10, draw.between(-9, -1));
    const bool falls = draw.whole(0, 1) == 1;
    const auto study =
        finished(head("bisection", fmt::format("search: x\ncondition: y {} 0\ntolerance: {:.17g}\n",
                                               falls ? "<" : ">", tolerance)) +
                 fmt::format("  - {{name: x, range: [{:.17g}, {:.17g}], log: {}}}\n", low, high,
                             draw.whole(0, 1) == 1) +
                 outcome(fmt::format("(x / {:.17g})^{:.17g} - 1", root, power)));
    const Finding found = finding_of(*study, "threshold");
    // The bracket holds the root but for the rounding of the power.
    EXPECT_LE(*found.low, root * (1 + 1e-12));
    EXPECT_GE(*found.high, root * (1 - 1e-12));
    EXPECT_LE(*found.high - *found.low, tolerance * (1 + 1e-12));
    EXPECT_LE(study->run_count(), study->most_runs());
  }
}

// Random convex quadratics, whose least values lie within the box or, along some axes, on its side.
TEST(RandomFunctions, OptimaOfQuadraticsAreFoundWithinTheBoxAndOnItsSides) {
  Draw draw(5);
  for (int function = 0; function < 30; ++function) {
    const bool is_largest = draw.whole(0, 1) == 1;
    const int n = draw.whole(1, 3);
    std::string text = head(is_largest ? "maximise" : "minimise", "runs: 4000\ntolerance: 1e-7\n"),
                formula = "0";
    std::vector<double> best, widths;
    for (int i = 0; i < n; ++i) {
      const double low = draw.between(-5, 5), width = draw.between(0.5, 5),
                   center = low + draw.between(-0.3, 1.3) * width;
      text += fmt::format("  - {{name: x{}, range: [{:.17g}, {:.17g}]}}\n", i, low, low + width);
      formula += fmt::format(" + {:.17g} * (x{} - ({:.17g}))^2", draw.between(0.5, 5), i, center);
      best.push_back(std::clamp(center, low, low + width)), widths.push_back(width);
    }
    const auto study = finished(text + outcome(is_largest ? "-(" + formula + ")" : formula));
    // A flat bottom tells a point to the root of the rounding: 1e-8 of the width; simplices end at 1e-7 of
    // it.
    for (std::size_t i = 0; i < best.size(); ++i)
      EXPECT_NEAR(finding_of(*study, fmt::format("x{}", i)).value, best[i], 1e-4 * widths[i])
          << text << formula;
  }
}

// The means over a grid of a linear function with noise of known mean, cell by cell.
TEST(RandomFunctions, MeansOverAGridHaveIntervalsThatHoldTheTruth) {
  Draw draw(6);
  int held = 0, all = 0;
  for (int function = 0; function < 10; ++function) {
    const double a = draw.between(-3, 3), s = draw.between(0.1, 2), low = draw.between(0.1, 1),
                 high = low + draw.between(1, 5);
    const auto study =
        finished(head("sweep", fmt::format("repeats: 40\nseed: {}\n", function + 1)) +
                 fmt::format("  - {{name: x, range: [{:.17g}, {:.17g}], count: 6, log: true}}\n"
                             "  - {{name: n, distribution: normal, deviation: {:.17g}}}\n",
                             low, high, s) +
                 outcome(fmt::format("{:.17g} * x + n", a)));
    for (int cell = 0; cell < 6; ++cell) {
      const double x = low * std::pow(high / low, cell / 5.0);
      const Finding y = finding_of(*study, fmt::format("y[{}]", cell));
      EXPECT_NEAR(y.value, a * x, 5 * s / std::sqrt(40.0));
      held += *y.low <= a * x && a * x <= *y.high ? 1 : 0;
      ++all;
    }
  }
  // 57 of 60 are expected, with a standard deviation of 1.7.
  EXPECT_GE(held, 51) << all;
}

// A pendulum that stands on its head and its neighbour on the way that leads from there: they part as exp(λ
// t) with λ = √(g / l), as long as the angle is small.
TEST(RandomFunctions, ChaosFindsTheExponentAndTheHorizonOfAnUnstableRest) {
  Draw draw(7);
  for (int pendulum = 0; pendulum < 6; ++pendulum) {
    const double l = draw.between(0.2, 3), g = draw.between(1, 20), rate = std::sqrt(g / l);
    const double apart = 1e-7 * draw.between(0.5, 5), bound = 1e-3 * l;
    const double horizon = std::log(bound / (l * apart)) / rate, interval = horizon / draw.between(80, 200);
    const std::string place = fmt::format("[\"{0:.17g}*sin(a)\", 0, \"{0:.17g}*cos(a)\"]", l);
    const auto study = finished(fmt::format(
        "rigor_study: 1\nscene: ../pendulum.yaml\nkind: chaos\nruns: 1\nperturb: a\nperturbation: "
        "{:.17g}\nbound: "
        "{:.17g}\n"
        "set:\n  run: {{duration: {:.17g}, step: 0.05, output_interval: {:.17g}}}\n  world.gravity: [0, 0, "
        "{:.17g}]\n"
        "  expect: []\nparameters: [{{name: a, values: [0]}}]\n"
        "assign:\n  bodies.ball.position: {}\n  joints.rod.anchors: [[0, 0, 0], {}]\n"
        "  bodies.ball.velocity: [\"{:.17g}*a*cos(a)\", 0, \"-{:.17g}*a*sin(a)\"]\noutcomes: []\n",
        apart, bound, 1.2 * horizon, interval, -g, place, place, l * rate, l * rate));
    EXPECT_NEAR(finding_of(*study, "lyapunov_exponent").value, rate, 1e-5 * rate);
    // The first output behind it; the angle's own share of its square moves it by 1e-6.
    const double found = finding_of(*study, "horizon").value;
    EXPECT_GT(found, horizon * (1 - 1e-5));
    EXPECT_LT(found, horizon * (1 + 1e-5) + interval);
  }
}

}  // namespace
}  // namespace rigor::random_functions_test
