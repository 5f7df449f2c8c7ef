#include "rigor/contact/system/face_normals.hpp"

#include "random_vectors.hpp"
#include "rigor/contact/system/contact_kinematics.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>
#include <Eigen/SVD>

namespace rigor::face_normals_test {
namespace {

using test::Random;

/// Two boxes that lie on each other, turned by so much about the vertical.
struct Pile {
  std::shared_ptr<const Model> model;
  Pose lower{Mat3::Identity(), Vec3::Zero()}, upper;
  std::vector<Contact> contacts;
};

Pile two_boxes(double turn, const Vec3& offset) {
  ModelBuilder builder;
  for (const std::string name : {"a", "b"}) {
    BodyDescription body;
    body.name = name;
    body.shapes.push_back({Box{Vec3(1, 0.8, 0.2)}});
    builder.add_body(body);
  }
  Pile pile;
  pile.model = builder.build();
  pile.upper = {rotation_matrix(rotation_exp(turn * Vec3::UnitZ())), Vec3(offset.x(), offset.y(), 0.2)};
  pile.contacts = find_contacts(*pile.model, 0, 1, pile.lower, pile.upper, 1e-6);
  return pile;
}

BodyKinetics moving(const Pose& pose, Random& random) {
  BodyKinetics body;
  body.x = pose.p;
  body.R = pose.R;
  body.v = random.vector();
  body.w = random.vector();
  body.inverse_mass = 1;
  return body;
}

/// Normal accelerations of the points, each with the place that it belongs to: (x, y, 1, ü_n) a row, where x
/// and y are along the face. Rows are dependent on three if what the points ask for is that of a plane.
double contradiction(const Pile& pile, std::vector<Contact> contacts, const Pose& upper, Random& random) {
  const BodyKinetics A = moving(pile.lower, random), B = moving(upper, random);
  MatX rows(static_cast<Eigen::Index>(contacts.size()), 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    Contact& contact = contacts[static_cast<std::size_t>(i)];
    contact.point = tracked_contact(*pile.model, contact, pile.lower, pile.upper, pile.lower, upper);
    const Vec3 along = B.R.transpose() * (contact.p_W() - B.x);
    rows.row(i) << along.x(), along.y(), 1, acceleration_bias(contact, A, B).z();
  }
  const VecX sizes = Eigen::JacobiSVD<MatX>(rows).singularValues();
  return sizes(3) / sizes(0);
}

TEST(FaceNormals, PointsOfTwoFacesDoNotContradictEachOtherWhereTheFacesTilt) {
  Random random(5);
  int mixed = 0;
  for (int k = 0; k < 50; ++k) {
    const Vec3 offset = 0.3 * random.vector();
    const Pile pile = two_boxes(random.uniform(-1.5, 1.5), offset);
    std::vector<Contact> shared = pile.contacts;
    share_normals_of_faces(shared);
    ASSERT_EQ(shared.size(), pile.contacts.size());
    if (shared.size() < 4) continue;
    // As within a step: the upper body has moved and tilted a little.
    Pose upper = pile.upper;
    upper.R = rotation_matrix(rotation_exp(1e-5 * random.vector())) * upper.R;
    upper.p += 1e-4 * random.vector();
    bool has_changed = false;
    for (std::size_t i = 0; i < shared.size(); ++i) {
      EXPECT_EQ(shared[i].point.p_WA, pile.contacts[i].point.p_WA);
      EXPECT_EQ(shared[i].point.n_W, pile.contacts[i].point.n_W);
      has_changed = has_changed ||
                    shared[i].point.curvature_A.flat_count != pile.contacts[i].point.curvature_A.flat_count;
    }
    Random motion(static_cast<unsigned>(k)), again(static_cast<unsigned>(k));
    EXPECT_LE(contradiction(pile, shared, upper, motion), 1e-14);
    if (!has_changed) continue;
    ++mixed;
    EXPECT_GE(contradiction(pile, pile.contacts, upper, again), 1e-9);
  }
  EXPECT_GE(mixed, 10);
}

TEST(FaceNormals, CornersStayWhereTheirBodyCarriesThem) {
  Pile pile = two_boxes(0.5, Vec3(0.2, 0.1, 0));
  std::vector<Contact> shared = pile.contacts;
  share_normals_of_faces(shared);
  Random random(7);
  // A motion that keeps the faces on each other.
  Pose upper = pile.upper;
  upper.R = rotation_matrix(rotation_exp(0.1 * Vec3::UnitZ())) * upper.R;
  upper.p += Vec3(0.02, -0.03, 0);
  for (std::size_t i = 0; i < shared.size(); ++i) {
    const auto moved = [&](const Contact& contact) {
      return tracked_contact(*pile.model, contact, pile.lower, pile.upper, pile.lower, upper);
    };
    const ContactPoint before = moved(pile.contacts[i]), now = moved(shared[i]);
    EXPECT_LE((before.p_WA - now.p_WA).norm(), 1e-15);
    EXPECT_LE((before.p_WB - now.p_WB).norm(), 1e-15);
    EXPECT_LE((before.n_W - now.n_W).norm(), 1e-15);
    EXPECT_NEAR(before.gap, now.gap, 1e-15);
  }
}

}  // namespace
}  // namespace rigor::face_normals_test
