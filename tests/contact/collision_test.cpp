#include "rigor/contact/impact/collision.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/system/collision_matrix.hpp"
#include "rigor/math/dense.hpp"
#include "solver/reference_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace rigor::collision_test {
namespace {

using test::Random;

constexpr std::array laws = {RestitutionLaw::newton, RestitutionLaw::poisson, RestitutionLaw::stronge};
constexpr std::array names = {"newton", "poisson", "stronge"};

Collision collision_of(const nlohmann::json& json) {
  return {{reference::matrix(json["K"]), json["mu"].get<double>()},
          reference::vector(json["u"]),
          json["e"].get<double>()};
}

double relative_error(const VecX& found, const nlohmann::json& expected) {
  const VecX reference = reference::vector(expected);
  return (found - reference).norm() / reference.norm();
}

/// Kinetic energy of the relative motion that an impact can change.
double energy_scale(const Collision& collision) {
  return 0.5 * collision.u.dot(symmetric_solution(collision.matrix.K, collision.u));
}

/// A rotation of random direction; K of random principal values with the given condition.
Mat3 random_matrix(Random& random, double condition) {
  const Mat3 axes = Eigen::HouseholderQR<Mat3>(Mat3{{random.number(), random.number(), random.number()},
                                                    {random.number(), random.number(), random.number()},
                                                    {random.number(), random.number(), random.number()}})
                        .householderQ();
  const Vec3 values(1, std::pow(condition, -random.uniform(0, 1)), 1 / condition);
  const Mat3 K = axes * values.asDiagonal() * axes.transpose();
  return 0.5 * (K + K.transpose());
}

Collision random_collision(Random& random) {
  const double condition = std::pow(10, random.uniform(0, 8));
  Collision collision{{random_matrix(random, condition), 0}, Vec3::Zero(), 0};
  collision.matrix.mu = random.uniform(0, 1) < 0.1 ? 0 : std::pow(10, random.uniform(-2, 1));
  collision.u = Vec3(random.number(), random.number(), -std::abs(random.number()));
  const double kind = random.uniform(0, 1);
  collision.restitution = kind < 0.1 ? 0 : kind < 0.2 ? 1 : random.uniform(0, 1);
  return collision;
}

TEST(Collision, AgreesWithTheReferenceImpactsUnderEveryLaw) {
  // Reference: the same equations in 128 bits, residuals below 1e-28. The bound is rounding times the
  // condition of the worst case.
  for (const nlohmann::json& json : reference::read("impact.json")["cases"]) {
    for (std::size_t law = 0; law < laws.size(); ++law) {
      const Collision collision = collision_of(json);
      const CollisionOutcome outcome = resolve_collision(collision, laws[law]);
      const nlohmann::json& expected = json[names[law]];
      SCOPED_TRACE(json["id"].get<std::string>() + " " + names[law]);
      ASSERT_TRUE(outcome.is_resolved);
      EXPECT_EQ(outcome.phases, expected["phases"].get<std::string>());
      EXPECT_LT(relative_error(outcome.end.u, expected["u"]), 1e-13);
      EXPECT_LT(relative_error(outcome.end.lambda, expected["lambda"]), 1e-13);
      EXPECT_NEAR(outcome.compression.work / expected["compression_work"].get<double>(), 1, 1e-13);
      EXPECT_NEAR(outcome.compression.lambda.z() / expected["compression_lambda_n"].get<double>(), 1, 1e-13);
      EXPECT_LT(
          (Vec2(outcome.compression.u.head<2>()) - reference::vector(expected["compression_slip"])).norm(),
          1e-13 * collision.u.norm());
      EXPECT_NEAR(outcome.end.work, expected["work"].get<double>(),
                  1e-13 * std::abs(outcome.compression.work));
      EXPECT_NEAR(outcome.energy_change, expected["energy_change"].get<double>(),
                  1e-13 * outcome.end.lambda.norm() * collision.u.norm());
    }
  }
}

TEST(Collision, CompressesAgainWhereTheNormalVelocityTurnsTwice) {
  for (const nlohmann::json& json : reference::read("recompression.json")["cases"]) {
    const Collision collision = collision_of(json);
    SCOPED_TRACE(json["id"].get<std::string>());
    const CollisionOutcome stronge = resolve_collision(collision, RestitutionLaw::stronge);
    EXPECT_EQ(stronge.phases, json["stronge"]["phases"].get<std::string>());
    // K has a condition of up to 2e4 here.
    EXPECT_LT(relative_error(stronge.end.u, json["stronge"]["u"]), 1e-12);
    EXPECT_LT(relative_error(stronge.end.lambda, json["stronge"]["lambda"]), 1e-12);
    // Poisson's law may end while the bodies approach: then the impact begins anew.
    const CollisionOutcome poisson = resolve_collision(collision, RestitutionLaw::poisson);
    const VecX first_end = reference::vector(json["poisson_first_end"]);
    EXPECT_GE(poisson.end.u.z(), 0);
    EXPECT_EQ(poisson.phases.find(';') != std::string::npos, first_end[2] < 0);
    if (first_end[2] >= 0) {
      EXPECT_LT((poisson.end.u - first_end).norm(), 1e-12 * first_end.norm());
    }
  }
}

TEST(Collision, NeverGainsEnergyUnderStrongeAndPoissonAndKeepsToTheCone) {
  Random random(17);
  int newton_gains = 0;
  for (int k = 0; k < 20000; ++k) {
    const Collision collision = random_collision(random);
    for (const RestitutionLaw law : laws) {
      const CollisionOutcome outcome = resolve_collision(collision, law);
      ASSERT_TRUE(outcome.is_resolved);
      ASSERT_TRUE(outcome.end.u.allFinite() && outcome.end.lambda.allFinite());
      const double energy = energy_scale(collision);
      if (law == RestitutionLaw::newton) {
        newton_gains += outcome.energy_change > 1e-6 * energy;
      } else {
        EXPECT_LE(outcome.energy_change, 1e-12 * energy);
      }
      EXPECT_GE(outcome.end.u.z(), 0);
      EXPECT_LE(outcome.end.lambda.head<2>().norm(),
                collision.matrix.mu * outcome.end.lambda.z() * (1 + 1e-12));
      const Vec3 u = collision.u + collision.matrix.K * outcome.end.lambda;
      EXPECT_LT((outcome.end.u - u).norm(), 1e-12 * (collision.u.norm() + outcome.end.lambda.norm()));
    }
  }
  // Newton's law does gain with friction, else this test would prove nothing about the others.
  EXPECT_GT(newton_gains, 0);
}

/// The impact up to the end of compression or to where slip stops, in small steps of the course's equations
/// in τ (dp = s dτ) by the classical Runge-Kutta method: θ, ln s, p, u_n, and the impulse of friction.
struct SlipEnd {
  bool has_stopped;
  double p, u_n;
  Vec2 friction;
};
SlipEnd follow_slip(const Collision& collision) {
  using Course = Eigen::Matrix<double, 6, 1>;
  const SlipFlow flow(collision.matrix);
  const auto rate = [&](const Course& y) {
    const Vec2 d(std::cos(y[0]), std::sin(y[0]));
    const double s = std::exp(y[1]);
    return (Course() << flow.angular_rate(d), flow.radial_rate(d), s, s * flow.normal_rate(d),
            -flow.mu * s * d)
        .finished();
  };
  Course y = Course::Zero();
  y.head<4>() << std::atan2(collision.u.y(), collision.u.x()), std::log(collision.u.head<2>().norm()), 0,
      collision.u.z();
  double h = 0.01 / flow.rate_bound();
  while (y[1] > -40) {
    const Course k1 = rate(y), k2 = rate(y + h / 2 * k1), k3 = rate(y + h / 2 * k2), k4 = rate(y + h * k3);
    const Course next = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    if (next[3] < 0) {
      y = next;
      continue;
    }
    // The last step is shortened until it ends at u_n = 0.
    if (next[3] < 1e-14 || h < 1e-18) return {false, next[2], next[3], next.tail<2>()};
    h *= std::min(0.99, -y[3] / (next[3] - y[3]) * (1 + 1e-9));
  }
  return {true, y[2], y[3], y.tail<2>()};
}

TEST(Collision, SlidesAsTheEquationsSayInSmallSteps) {
  Random random(57);
  int stopped = 0;
  for (int k = 0; k < 150; ++k) {
    Collision collision = random_collision(random);
    collision.matrix.K = random_matrix(random, std::pow(10, random.uniform(0, 2)));
    collision.matrix.mu = random.uniform(0.1, 1.5);
    collision.restitution = 0;
    const SlipEnd expected = follow_slip(collision);
    std::vector<CollisionPoint> path;
    const CollisionOutcome outcome = resolve_collision(collision, RestitutionLaw::stronge, &path);
    SCOPED_TRACE(std::to_string(k) + " " + outcome.phases);
    CollisionPoint end = outcome.end;
    EXPECT_EQ(outcome.phases == "S|", !expected.has_stopped);
    if (expected.has_stopped) {
      ++stopped;
      const auto stop = std::find_if(path.begin(), path.end(), [&](const CollisionPoint& point) {
        return point.u.head<2>().norm() < 1e-14 * collision.u.norm();
      });
      ASSERT_NE(stop, path.end());
      end = *stop;
    }
    // Steps of a hundredth, order 4: 1e-8 of a global error constant that is far below one.
    EXPECT_NEAR(end.lambda.z(), expected.p, 1e-8 * expected.p);
    EXPECT_LT((Vec2(end.lambda.head<2>()) - expected.friction).norm(), 1e-8 * expected.p);
    EXPECT_NEAR(end.u.z(), expected.u_n, 1e-8 * collision.u.norm());
  }
  EXPECT_GT(stopped, 20);
}

TEST(Collision, EndsByItsLaw) {
  Random random(23);
  for (int k = 0; k < 3000; ++k) {
    const Collision collision = random_collision(random);
    const double e = collision.restitution;
    const CollisionOutcome newton = resolve_collision(collision, RestitutionLaw::newton);
    if (newton.phases.find(';') == std::string::npos) {
      EXPECT_EQ(newton.end.u.z(), -e * collision.u.z());
    }
    const CollisionOutcome poisson = resolve_collision(collision, RestitutionLaw::poisson);
    if (poisson.phases.find(';') == std::string::npos) {
      EXPECT_NEAR(poisson.end.lambda.z() / poisson.compression.lambda.z(), 1 + e, 1e-13);
    }
    const CollisionOutcome stronge = resolve_collision(collision, RestitutionLaw::stronge);
    if (stronge.phases.find('r') == std::string::npos) {
      EXPECT_NEAR(stronge.end.work, (1 - e * e) * stronge.compression.work,
                  1e-12 * std::abs(stronge.compression.work));
    }
  }
}

/// Routh's planar impact with M = a, coupling b, κ = c: a walk over at most three straight pieces.
struct PlanarEnd {
  double u_t, u_n, lambda_t, lambda_n;
};
PlanarEnd routh(double a, double b, double c, double mu, const Vec2& u, double e, RestitutionLaw law) {
  double u_t = u.x(), u_n = u.y(), p = 0, lambda_t = 0, work = 0, p_c = 0, work_c = 0;
  bool compresses = true;
  while (true) {
    const bool slips = u_t != 0;
    const bool sticks = !slips && std::abs(b) <= mu * a;
    const double sigma = slips ? std::copysign(1, u_t) : std::copysign(1, b);
    const double friction = sticks ? -b / a : -mu * sigma;
    const double t_rate = sticks ? 0 : b + a * friction, n_rate = c + b * friction;
    const double stop = slips && t_rate * sigma < 0 ? -u_t / t_rate : std::numeric_limits<double>::infinity();
    const auto go = [&](double step) {
      work += step * (u_n + 0.5 * n_rate * step);
      u_n += n_rate * step, u_t = step == stop ? 0 : u_t + t_rate * step;
      lambda_t += friction * step, p += step;
    };
    double limit = 0;
    if (compresses) {
      limit = n_rate > 0 ? -u_n / n_rate : std::numeric_limits<double>::infinity();
    } else if (law == RestitutionLaw::newton) {
      limit = (-e * u.y() - u_n) / n_rate;
    } else if (law == RestitutionLaw::poisson) {
      limit = (1 + e) * p_c - p;
    } else {
      const double gain = (1 - e * e) * work_c - work;
      limit = (-u_n + std::sqrt(u_n * u_n + 2 * n_rate * gain)) / n_rate;
    }
    if (stop < limit) {
      go(stop);
      continue;
    }
    go(limit);
    if (!compresses) return {u_t, u_n, lambda_t, p};
    compresses = false;
    p_c = p, work_c = work;
  }
}

TEST(Collision, ReproducesRouthsPlanarSolutions) {
  // The plane of the motion is turned by a random angle. Compared are velocities relative to those before.
  Random random(31);
  for (int k = 0; k < 1000; ++k) {
    const double a = random.uniform(0.5, 4), c = random.uniform(0.5, 4);
    const double b = random.uniform(-0.9, 0.9) * std::sqrt(a * c), mu = random.uniform(0, 1.5);
    const Vec2 u(random.uniform(-2, 2), -random.uniform(0.1, 2));
    const double e = random.uniform(0, 1);
    const bool is_turned = k % 2 == 1;
    const double angle = is_turned ? random.uniform(-3, 3) : 0;
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitZ()).toRotationMatrix();
    Mat3 K;
    K << a, 0, b, 0, random.uniform(0.5, 4), 0, b, 0, c;
    Collision collision{{R * K * R.transpose(), mu}, R * Vec3(u.x(), 0, u.y()), e};
    collision.matrix.K = 0.5 * (collision.matrix.K + collision.matrix.K.transpose()).eval();
    for (const RestitutionLaw law : laws) {
      const PlanarEnd expected = routh(a, b, c, mu, u, e, law);
      const CollisionOutcome outcome = resolve_collision(collision, law);
      // A plane that turned against the axes by rounding is an unstable path where slip turns round: what
      // rounding leaves across it grows. Along the axes the solution is Routh's to the last digits.
      const double tolerance = is_turned ? 1e-12 : 1e-13;
      const Vec3 v = R.transpose() * outcome.end.u, lambda = R.transpose() * outcome.end.lambda;
      EXPECT_LT((v - Vec3(expected.u_t, 0, expected.u_n)).norm(), 10 * tolerance * u.norm())
          << outcome.phases;
      EXPECT_LT((lambda - Vec3(expected.lambda_t, 0, expected.lambda_n)).norm(),
                tolerance * std::abs(expected.lambda_n))
          << outcome.phases;
    }
  }
}

TEST(Collision, FollowsTheClosedFormOfAnObliqueSphere) {
  // Solid sphere, K = diag(7/2, 7/2, 1)/m: rolls on if μ ≥ (2/7) v_t/((1 + e) v_n), else slides throughout.
  const double m = 0.3, v_t = 1.7, v_n = 2.1, e = 0.6;
  const Mat3 K = Vec3(3.5, 3.5, 1).asDiagonal().toDenseMatrix() / m;
  const double limit = 2.0 / 7 * v_t / ((1 + e) * v_n);
  for (const RestitutionLaw law : laws) {
    const CollisionOutcome rolls =
        resolve_collision({{K, 1.01 * limit}, {v_t * 0.6, v_t * 0.8, -v_n}, e}, law);
    EXPECT_EQ(rolls.end.u.x(), 0);
    EXPECT_EQ(rolls.end.u.y(), 0);
    EXPECT_NEAR(rolls.end.lambda.head<2>().norm(), m * v_t * 2 / 7, 1e-15);
    const CollisionOutcome slides =
        resolve_collision({{K, 0.9 * limit}, {v_t * 0.6, v_t * 0.8, -v_n}, e}, law);
    EXPECT_NEAR(slides.end.u.head<2>().norm(), v_t - 3.5 * 0.9 * limit * (1 + e) * v_n, 1e-15);
    EXPECT_NEAR(slides.end.u.z(), e * v_n, 1e-15);
  }
}

TEST(Collision, WithInfiniteFrictionIsTheLimitOfLargeFriction) {
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    Collision collision = random_collision(random);
    collision.matrix.K = random_matrix(random, std::pow(10, random.uniform(0, 2)));
    for (const RestitutionLaw law : laws) {
      collision.matrix.mu = std::numeric_limits<double>::infinity();
      const CollisionOutcome infinite = resolve_collision(collision, law);
      ASSERT_TRUE(infinite.is_resolved);
      collision.matrix.mu = 1e9;
      const CollisionOutcome large = resolve_collision(collision, law);
      if (large.phases.find('r') != std::string::npos || large.phases.find(';') != std::string::npos)
        continue;
      // First order in 1/μ, times the condition of K.
      EXPECT_LT((infinite.end.u - large.end.u).norm(), 1e-5 * collision.u.norm())
          << infinite.phases << " " << large.phases;
    }
  }
}

TEST(Collision, LeavesAloneWhatDoesNotApproach) {
  const Mat3 K = Vec3(3, 2, 1).asDiagonal();
  for (const double u_n : {0.0, 1e-300, 2.0}) {
    const CollisionOutcome outcome = resolve_collision({{K, 0.5}, {1, 2, u_n}, 0.5}, RestitutionLaw::stronge);
    EXPECT_EQ(outcome.end.u, Vec3(1, 2, u_n));
    EXPECT_EQ(outcome.end.lambda, Vec3(0, 0, 0));
    EXPECT_TRUE(outcome.phases.empty());
  }
}

TEST(Collision, StartsFromAJamWithoutApproach) {
  // Painlevé's rod: sliding presses the tip into the floor although it does not approach. The impulse makes
  // it stick; with K = [a b; b c] the normal velocity then grows again until it is zero, so e = 0 ends there.
  const double a = 2.5, b = 1.5, c = 2.5, mu = 2;
  Mat3 K;
  K << a, 0, b, 0, 1, 0, b, 0, c;
  const CollisionOutcome outcome = resolve_collision({{K, mu}, {1, 0, 0}, 0}, RestitutionLaw::stronge);
  EXPECT_EQ(outcome.phases, "SK|");
  EXPECT_EQ(outcome.end.u, Vec3(0, 0, 0));
  const Vec3 lambda = -K.inverse() * Vec3(1, 0, 0);
  EXPECT_LT((outcome.end.lambda - lambda).norm(), 1e-14);
}

TEST(Collision, WithAMasslessDirectionKeepsThatSlip) {
  // Nothing can change u_y: friction turns towards it as u_x goes.
  Mat3 K;
  K << 2, 0, 0.5, 0, 0, 0, 0.5, 0, 1;
  const CollisionOutcome outcome =
      resolve_collision({{K, 0.4}, {0.3, 0.7, -1}, 0.5}, RestitutionLaw::stronge);
  ASSERT_TRUE(outcome.is_resolved);
  EXPECT_NEAR(outcome.end.u.y(), 0.7, 1e-15);
  EXPECT_GT(outcome.end.u.z(), 0);
  // Without slip in it, the problem is planar.
  const PlanarEnd planar = routh(2, 0.5, 1, 0.4, {0.3, -1}, 0.5, RestitutionLaw::stronge);
  const CollisionOutcome flat = resolve_collision({{K, 0.4}, {0.3, 0, -1}, 0.5}, RestitutionLaw::stronge);
  EXPECT_NEAR(flat.end.u.x(), planar.u_t, 1e-15);
  EXPECT_NEAR(flat.end.u.z(), planar.u_n, 1e-15);
}

TEST(Collision, CannotMoveWhatIsRigidAlongTheNormal) {
  const CollisionOutcome outcome =
      resolve_collision({{Vec3(1, 1, 0).asDiagonal(), 0.5}, {1, 0, -1}, 0.5}, RestitutionLaw::stronge);
  EXPECT_FALSE(outcome.is_resolved);
  EXPECT_EQ(outcome.end.u, Vec3(1, 0, -1));
}

TEST(Collision, TellsThePathThatItTakes) {
  std::vector<CollisionPoint> path;
  const Collision collision = collision_of(reference::read("impact.json")["cases"][0]);
  const CollisionOutcome outcome = resolve_collision(collision, RestitutionLaw::stronge, &path);
  ASSERT_GE(path.size(), 9u);
  EXPECT_EQ(path.front().u, collision.u);
  EXPECT_LT((path.back().u - outcome.end.u).norm(), 1e-15);
  for (std::size_t k = 1; k < path.size(); ++k) {
    EXPECT_GT(path[k].lambda.z(), path[k - 1].lambda.z());
    EXPECT_LT((collision.u + collision.matrix.K * path[k].lambda - path[k].u).norm(), 1e-14);
  }
}

TEST(Collision, WithUnitsScaledByPowersOfTwoGivesTheSameBits) {
  Random random(41);
  for (int k = 0; k < 200; ++k) {
    const Collision collision = random_collision(random);
    Collision scaled = collision;
    scaled.matrix.K *= 0x1p9;
    scaled.u *= 0x1p-20;
    const CollisionOutcome a = resolve_collision(collision, RestitutionLaw::stronge);
    const CollisionOutcome b = resolve_collision(scaled, RestitutionLaw::stronge);
    EXPECT_EQ(Vec3(a.end.u * 0x1p-20), b.end.u);
    EXPECT_EQ(Vec3(a.end.lambda * 0x1p-29), b.end.lambda);
  }
}

TEST(Collision, OfAJointedChainIsKanesDoublePendulum) {
  // Two rods as free planar bodies (x, z, angle from the downward vertical), joints as rows of G.
  const nlohmann::json data = reference::read("kane.json");
  const double t1 = 20 * M_PI / 180, t2 = 30 * M_PI / 180, I = 1.0 / 12;
  const Vec6 masses = (Vec6() << 1, 1, I, 1, 1, I).finished();
  const MatX inverse_mass = masses.cwiseInverse().asDiagonal();
  // Of a point at ±1/2 along a rod at angle t (downward): x = ± sin t / 2, z = ∓ cos t / 2.
  const double c1 = std::cos(t1) / 2, s1 = std::sin(t1) / 2, c2 = std::cos(t2) / 2, s2 = std::sin(t2) / 2;
  MatX G = MatX::Zero(5, 6), J = MatX::Zero(3, 6);
  G.row(0) << 1, 0, -c1, 0, 0, 0;
  G.row(1) << 0, 1, -s1, 0, 0, 0;
  G.row(2) << 1, 0, c1, -1, 0, c2;
  G.row(3) << 0, 1, s1, 0, -1, s2;
  G.row(4) = G.row(2) + G.row(0);  // redundant
  J.row(0) << 0, 0, 0, 1, 0, c2;
  J.row(2) << 0, 0, 0, 0, 1, s2;
  const Mat3 K = constrained_collision_matrix(inverse_mass, J, G);
  const MatX expected = reference::matrix(data["K"]);
  EXPECT_NEAR(K(0, 0), expected(0, 0), 1e-14);
  EXPECT_NEAR(K(0, 2), expected(0, 1), 1e-14);
  EXPECT_NEAR(K(2, 2), expected(1, 1), 1e-14);
  EXPECT_TRUE(K.row(1).isZero(0));

  const double w1 = -0.1, w2 = -0.2;
  const VecX V =
      (Vec6() << c1 * w1, s1 * w1, w1, 2 * c1 * w1 + c2 * w2, 2 * s1 * w1 + s2 * w2, w2).finished();
  ASSERT_LT((G * V).norm(), 1e-16);
  const Vec3 u = J * V;
  const double energy = 0.5 * V.dot(masses.cwiseProduct(V));
  for (const nlohmann::json& json : data["cases"]) {
    for (std::size_t law = 0; law < laws.size(); ++law) {
      SCOPED_TRACE(json["id"].get<std::string>() + " " + names[law]);
      const nlohmann::json& result = json[names[law]];
      const CollisionOutcome outcome = resolve_collision({{K, json["mu"]}, u, json["e"]}, laws[law]);
      EXPECT_EQ(outcome.phases, result["phases"].get<std::string>());
      const VecX after = V + constrained_velocity_change(inverse_mass, J, G, outcome.end.lambda);
      EXPECT_LT((Vec2(after[2], after[5]) - reference::vector(result["rates"])).norm(), 1e-13);
      // Newton's law makes energy out of nothing here: three times what there was.
      EXPECT_NEAR(0.5 * after.dot(masses.cwiseProduct(after)) / energy, result["ratio"].get<double>(), 1e-11);
      EXPECT_NEAR(outcome.energy_change / energy + 1, result["ratio"].get<double>(), 1e-11);
    }
  }
}

TEST(CollisionMatrix, IsRefusedWhenItIsNoMatrixOfAnImpact) {
  Mat3 K = Vec3(3, 2, 1).asDiagonal();
  EXPECT_EQ(check_collision_matrix(K), "");
  K(0, 1) = 0.1;
  EXPECT_NE(check_collision_matrix(K).find("symmetric"), std::string::npos);
  K(1, 0) = 0.1;
  EXPECT_EQ(check_collision_matrix(K), "");
  K(0, 1) = K(1, 0) = 3;
  EXPECT_NE(check_collision_matrix(K).find("smallest eigenvalue"), std::string::npos);
  EXPECT_NE(check_collision_matrix(Vec3(1, 1, 0).asDiagonal()).find("K[2][2]"), std::string::npos);
  K(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(check_collision_matrix(K).find("finite"), std::string::npos);
}

}  // namespace
}  // namespace rigor::collision_test
