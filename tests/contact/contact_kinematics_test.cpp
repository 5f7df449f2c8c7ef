#include "rigor/contact/system/contact_kinematics.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/system/contact_system.hpp"
#include "rigor/geometry/distance/distance.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

namespace rigor::contact_kinematics_test {
namespace {

using test::Random;

std::shared_ptr<const Model> pair_of(const Shape& a, const Shape& b) {
  ModelBuilder builder;
  for (const auto& [name, shape] : {std::pair<std::string, Shape>{"a", a}, {"b", b}}) {
    BodyDescription body;
    body.name = name;
    body.shapes.push_back({shape});
    builder.add_body(body);
  }
  return builder.build();
}

/// Body that turns at w and whose centre moves at v, both constant.
BodyKinetics moving_body(const Body& body, const Vec3& x, const Mat3& R, const Vec3& v, const Vec3& w) {
  BodyKinetics result;
  result.x = x;
  result.R = R;
  result.v = v;
  result.w = w;
  result.inverse_mass = 1 / body.mass;
  result.inertia = R * body.moments.asDiagonal() * R.transpose();
  result.inverse_inertia = result.inertia.inverse();
  return result;
}

BodyKinetics later(const BodyKinetics& body, double t) {
  BodyKinetics result = body;
  result.x += t * body.v;
  result.R = rotation_matrix(rotation_exp(t * body.w)) * body.R;
  return result;
}

double gap_of(const Model& model, const BodyKinetics& A, const BodyKinetics& B) {
  const BodyShape& a = model.body(0).shapes.front();
  const BodyShape& b = model.body(1).shapes.front();
  return signed_distance(a.shape, A.pose() * a.X_BS, b.shape, B.pose() * b.X_BS).distance;
}

Shape shape_of(int kind) {
  switch (kind) {
    case 0:
      return Sphere{0.4};
    case 1:
      return Box{Vec3(0.5, 0.3, 0.2)};
    case 2:
      return Capsule{0.2, 0.5};
    case 3:
      return Ellipsoid{Vec3(0.5, 0.3, 0.4)};
    default:
      return Cylinder{0.3, 0.4};
  }
}

// g̈ of two bodies with constant v and ω is the bias alone; both derivatives against differences of the exact
// distance.
void expect_gap_derivatives(const Shape& a, const Shape& b, double apart, Random& random) {
  const auto model = pair_of(a, b);
  BodyKinetics A =
      moving_body(model->body(0), Vec3::Zero(), rotation_matrix(rotation_exp(3 * random.vector())),
                  0.5 * random.vector(), random.vector());
  BodyKinetics B =
      moving_body(model->body(1), 3 * random.vector().normalized(),
                  rotation_matrix(rotation_exp(3 * random.vector())), 0.5 * random.vector(), random.vector());
  // Into each other and out again by the shortest way: then a corner meets a face or two edges cross, not two
  // corners.
  const BodyShape& shape_a = model->body(0).shapes.front();
  const BodyShape& shape_b = model->body(1).shapes.front();
  for (const double gap : {-0.01, apart}) {
    const DistanceResult now =
        signed_distance(shape_a.shape, A.pose() * shape_a.X_BS, shape_b.shape, B.pose() * shape_b.X_BS);
    B.x -= (now.distance - gap) * now.n_W;
  }
  const std::vector<Contact> contacts = find_contacts(*model, 0, 1, A.pose(), B.pose(), apart + 1e-6);
  ASSERT_EQ(contacts.size(), 1u);
  const Contact& contact = contacts.front();

  // Central differences over d and over 2d: the second tells the error of the first, which is large where a
  // rim all but grazes an edge. The pair of features must stay the same over them: corners and edges do
  // unless they are grazed.
  const auto gap_at = [&](double s) { return gap_of(*model, later(A, s), later(B, s)); };
  const auto rate_over = [&](double s) { return (gap_at(s) - gap_at(-s)) / (2 * s); };
  const auto bend_over = [&](double s) { return (gap_at(s) - 2 * gap_at(0) + gap_at(-s)) / (s * s); };
  constexpr double d = 1e-4;
  EXPECT_NEAR(relative_velocity(contact, A, B).z(), rate_over(d),
              3e-8 + std::abs(rate_over(2 * d) - rate_over(d)));
  EXPECT_NEAR(acceleration_bias(contact, A, B).z(), bend_over(d),
              3e-6 + std::abs(bend_over(2 * d) - bend_over(d)));
}

TEST(ContactKinematics, GapRatesOfRandomPairsAreThoseOfTheDistance) {
  Random random(11);
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) {
      SCOPED_TRACE(std::to_string(a) + " on " + std::to_string(b));
      for (int trial = 0; trial < 8; ++trial) expect_gap_derivatives(shape_of(a), shape_of(b), 1e-9, random);
    }
  }
}

/// A gap that is open rotates with its normal: its ends are two places, whose velocities differ.
TEST(ContactKinematics, GapRatesOfPairsThatAreApartAreThoseOfTheDistance) {
  Random random(13);
  for (int a = 0; a < 5; ++a) {
    for (int b = 0; b < 5; ++b) {
      SCOPED_TRACE(std::to_string(a) + " on " + std::to_string(b));
      for (int trial = 0; trial < 8; ++trial) expect_gap_derivatives(shape_of(a), shape_of(b), 0.03, random);
    }
  }
}

/// A cone that leans with the rim of its base and turns about its axis: the rim bends about the axis,
/// wherever on it the cone touches.
TEST(ContactKinematics, TheRimOfATurningConeIsTrackedAsItIsFoundAnew) {
  Random random(14);
  for (int trial = 0; trial < 50; ++trial) {
    const double radius = 0.3 + 0.2 * random.number();
    const auto model = pair_of(Box{Vec3(2, 2, 0.5)}, Cone{radius, 0.3 + 0.2 * random.number()});
    const BodyKinetics A =
        moving_body(model->body(0), Vec3::Zero(), Mat3::Identity(), 0.2 * random.vector(), random.vector());
    const double tilt = 0.35 + 0.25 * random.number();
    BodyKinetics B = moving_body(model->body(1), Vec3(0.1, -0.2, 2),
                                 rotation_matrix(rotation_exp(tilt * Vec3::UnitY())) *
                                     rotation_matrix(rotation_exp(3 * random.number() * Vec3::UnitZ())),
                                 0.2 * random.vector(), random.vector());
    B.w += 20 * B.R.col(2);
    B.x.z() -= gap_of(*model, A, B);
    const std::vector<Contact> contacts = find_contacts(*model, 0, 1, A.pose(), B.pose(), 1e-6);
    ASSERT_EQ(contacts.size(), 1u);
    const BodyKinetics A1 = later(A, 0.004), B1 = later(B, 0.004);
    const ContactPoint tracked =
        tracked_contact(*model, contacts.front(), A.pose(), B.pose(), A1.pose(), B1.pose());
    const std::vector<Contact> anew = find_contacts(*model, 0, 1, A1.pose(), B1.pose(), 0.01);
    ASSERT_EQ(anew.size(), 1u);
    EXPECT_NEAR(tracked.gap, gap_of(*model, A1, B1), 1e-12);
    EXPECT_LE((tracked.p_WB - anew.front().point.p_WB).norm(), 1e-10);
    EXPECT_LE((tracked.curvature_B.radius_W - anew.front().point.curvature_B.radius_W).norm(), 1e-10);
  }
}

TEST(ContactKinematics, TrackedContactsStayTheSamePairOfFeatures) {
  Random random(12);
  const auto model = pair_of(Box{Vec3(0.5, 0.3, 0.2)}, Ellipsoid{Vec3(0.5, 0.3, 0.4)});
  for (int trial = 0; trial < 50; ++trial) {
    const BodyKinetics A =
        moving_body(model->body(0), Vec3::Zero(), Mat3::Identity(), 0.2 * random.vector(), random.vector());
    BodyKinetics B = moving_body(model->body(1), Vec3(0.1 * random.number(), 0.1 * random.number(), 2),
                                 rotation_matrix(rotation_exp(3 * random.vector())), 0.2 * random.vector(),
                                 random.vector());
    B.x.z() -= gap_of(*model, A, B);
    const std::vector<Contact> contacts = find_contacts(*model, 0, 1, A.pose(), B.pose(), 1e-6);
    ASSERT_EQ(contacts.size(), 1u);
    const BodyKinetics A1 = later(A, 0.01), B1 = later(B, 0.01);
    const ContactPoint tracked =
        tracked_contact(*model, contacts.front(), A.pose(), B.pose(), A1.pose(), B1.pose());
    EXPECT_NEAR(tracked.gap, gap_of(*model, A1, B1), 1e-12);
    EXPECT_LE((tracked.n_W - A1.R * A.R.transpose() * contacts.front().point.n_W).norm(), 1e-12);
    // It bends there as the contact that is found anew: the normal has moved over the ellipsoid.
    const std::vector<Contact> anew = find_contacts(*model, 0, 1, A1.pose(), B1.pose(), 0.01);
    ASSERT_EQ(anew.size(), 1u);
    EXPECT_LE((tracked.curvature_B.radius_W - anew.front().point.curvature_B.radius_W).norm(), 1e-10);
  }
}

/// Two edges that cross at this angle, one body above the other, with random motions.
struct CrossedEdges {
  Contact contact;
  std::shared_ptr<const Model> model = pair_of(Box{Vec3(0.5, 0.3, 0.2)}, Box{Vec3(0.5, 0.3, 0.2)});
  BodyKinetics A, B;

  CrossedEdges(double angle, Random& random) {
    const Vec3 along_A = Vec3::UnitX(), along_B(std::cos(angle), std::sin(angle), 0);
    A = moving_body(model->body(0), Vec3(0, 0, -0.3), Mat3::Identity(), random.vector(), random.vector());
    B = moving_body(model->body(1), Vec3(0, 0, 0.3), Mat3::Identity(), random.vector(), random.vector());
    contact.body_A = 0;
    contact.body_B = 1;
    contact.shape_A = contact.shape_B = 0;
    contact.point.n_W = Vec3::UnitZ();
    contact.point.gap = 1e-3;
    contact.point.p_WA = Vec3::Zero();
    contact.point.p_WB = 1e-3 * Vec3::UnitZ();
    for (const auto& [curvature, along] :
         {std::pair{&contact.point.curvature_A, along_A}, std::pair{&contact.point.curvature_B, along_B}}) {
      curvature->radius_W.setZero();
      curvature->flat_count = 1;
      curvature->flat_W = along;
    }
  }

  Vec3 normal_after(double t) const {
    return tracked_contact(*model, contact, A.pose(), B.pose(), later(A, t).pose(), later(B, t).pose()).n_W;
  }
};

TEST(ContactKinematics, NormalsOfCrossedEdgesRotateAsTheirDifferencesDo) {
  Random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    const double angle = std::pow(10.0, 2 * random.uniform(-1, 0));
    const CrossedEdges edges(angle, random);
    // Central differences over a time in which the edges turn by little against the angle between them.
    const double dt = 1e-5 * angle;
    const Vec3 difference = (edges.normal_after(dt) - edges.normal_after(-dt)) / (2 * dt);
    const Vec3 rate = normal_rate(edges.contact, edges.A, edges.B);
    EXPECT_LE((rate - difference).norm(), 1e-6 * (1 + 1 / angle)) << angle;
  }
}

TEST(ContactKinematics, EdgesThatBecomeParallelKeepTheirPoints) {
  Random random(43);
  const CrossedEdges edges(0.3, random);
  BodyKinetics B = edges.B;
  B.R = rotation_matrix(rotation_exp(Vec3(0, 0, -0.3))) * B.R;
  const ContactPoint point =
      tracked_contact(*edges.model, edges.contact, edges.A.pose(), edges.B.pose(), edges.A.pose(), B.pose());
  EXPECT_TRUE(std::isfinite(point.gap));
  EXPECT_TRUE(point.p_WA.allFinite() && point.p_WB.allFinite() && point.n_W.allFinite());
  EXPECT_NEAR(point.n_W.norm(), 1, 1e-12);
}

TEST(ContactKinematics, ARimThatComesToLieFlatIsTrackedThere) {
  // The lowest point of a tilted cylinder touches a box; upright, no point of its rim is the lowest.
  const Cylinder cylinder{0.3, 0.4};
  const auto model = pair_of(Box{Vec3(2, 2, 0.5)}, cylinder);
  const BodyKinetics A =
      moving_body(model->body(0), Vec3(0, 0, -0.5), Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
  for (const double tilt : {0.5, 0.1, -0.2}) {
    BodyKinetics B =
        moving_body(model->body(1), Vec3(0, 0, 2), rotation_matrix(rotation_exp(tilt * Vec3::UnitY())),
                    Vec3(1, 0, 0), Vec3(0, -3, 1));
    B.x.z() -= gap_of(*model, A, B);
    const std::vector<Contact> contacts = find_contacts(*model, 0, 1, A.pose(), B.pose(), 1e-6);
    ASSERT_EQ(contacts.size(), 1u);
    BodyKinetics upright = B;
    upright.R = Mat3::Identity();
    upright.x.z() = cylinder.half_length + 0.01;
    Contact tracked = contacts.front();
    tracked.point = tracked_contact(*model, tracked, A.pose(), B.pose(), A.pose(), upright.pose());
    EXPECT_NEAR(tracked.point.gap, 0.01, 1e-12);
    EXPECT_TRUE(tracked.point.curvature_B.radius_W.allFinite()) << tilt;
    EXPECT_TRUE(acceleration_bias(tracked, A, upright).allFinite()) << tilt;
  }
}

TEST(ContactKinematics, TheLowestPointOfARimGoesRoundFastWhereItIsNearlyFlat) {
  // Over a time in which the tilt changes little, the point moves along the rim by the rate times its arm.
  Random random(47);
  const auto model = pair_of(Box{Vec3(2, 2, 0.5)}, Cylinder{0.3, 0.4});
  const BodyKinetics A =
      moving_body(model->body(0), Vec3(0, 0, -0.5), Mat3::Identity(), Vec3::Zero(), Vec3::Zero());
  for (int trial = 0; trial < 50; ++trial) {
    const double tilt = std::pow(10.0, random.uniform(-4, -2));
    BodyKinetics B =
        moving_body(model->body(1), Vec3(0, 0, 2), rotation_matrix(rotation_exp(tilt * Vec3::UnitY())),
                    random.vector(), random.vector());
    B.x.z() -= gap_of(*model, A, B);
    const std::vector<Contact> contacts = find_contacts(*model, 0, 1, A.pose(), B.pose(), 1e-9);
    ASSERT_EQ(contacts.size(), 1u);
    const Contact& contact = contacts.front();
    const double dt = 1e-4 * tilt;
    const auto point_after = [&](double t) {
      return tracked_contact(*model, contact, A.pose(), B.pose(), A.pose(), later(B, t).pose()).p_WB;
    };
    const double speed = (point_after(dt) - point_after(-dt)).norm() / (2 * dt);
    const double arm = std::max((contact.p_W() - A.x).norm(), (contact.p_W() - B.x).norm());
    const double bodies = 2 * (B.v.norm() + B.w.norm());
    EXPECT_NEAR(feature_rate(contact, A, B) * arm, speed, 1e-3 * speed + bodies) << tilt;
  }
}

TEST(ContactSystem, ImpulsesChangeVelocitiesByTheDelassusOperator) {
  Random random(13);
  const auto model = pair_of(Box{Vec3(0.5, 0.3, 0.2)}, Box{Vec3(0.2, 0.3, 0.4)});
  for (int trial = 0; trial < 20; ++trial) {
    const BodyKinetics A =
        moving_body(model->body(0), Vec3::Zero(), rotation_matrix(rotation_exp(random.vector())),
                    random.vector(), random.vector());
    const BodyKinetics B =
        moving_body(model->body(1), Vec3(0, 0, 0.7), rotation_matrix(rotation_exp(random.vector())),
                    random.vector(), random.vector());
    std::vector<Contact> contacts;
    for (int k = 0; k < 3; ++k) {
      Contact contact{};
      contact.body_B = 1;
      contact.point.n_W = random.vector().normalized();
      contact.point.p_WA = contact.point.p_WB = Vec3(0, 0, 0.35) + 0.2 * random.vector();
      contacts.push_back(contact);
    }
    ContactSystem system = make_contact_system(contacts, {0, 1}, {A, B});
    VecX lambda(9);
    for (int k = 0; k < 9; ++k) lambda[k] = random.number();
    const VecX before = relative_velocities(system);
    const double energy = kinetic_energy(system);
    const MatX D = delassus(system);
    EXPECT_EQ(D, D.transpose());
    apply_impulses(lambda, system);
    const VecX after = relative_velocities(system);
    EXPECT_LE((after - before - D * lambda).cwiseAbs().maxCoeff(), 1e-12 * D.norm());
    // ΔT = λ · (u + u⁺)/2.
    EXPECT_NEAR(kinetic_energy(system) - energy, 0.5 * lambda.dot(before + after), 1e-12 * D.norm());
  }
}

}  // namespace
}  // namespace rigor::contact_kinematics_test
