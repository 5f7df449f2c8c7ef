// Bodies with equal shapes share them.

#include "rigor/model/body_shapes.hpp"

#include "rigor/geometry/shape/convex_hull.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace rigor::body_shapes_test {
namespace {

std::shared_ptr<const ConvexHull> tetrahedron() {
  return std::make_shared<const ConvexHull>(
      std::get<ConvexHull>(make_convex_hull({Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})));
}

BodyShape shape_of(const Shape& shape) {
  return {.shape = shape};
}

BodyShapes shapes_of(const BodyShape& shape, std::size_t count = 1) {
  return std::vector<BodyShape>(count, shape);
}

bool do_share(const BodyShape& a, const BodyShape& b) {
  SharedShapes shared;
  BodyShapes first = shapes_of(a), second = shapes_of(b);
  shared.share(first);
  shared.share(second);
  return &first.all() == &second.all();
}

TEST(BodyShapes, EqualOnesAreSharedWhateverTheirForm) {
  const Convex hull{tetrahedron()};
  for (const Shape& shape : {Shape(Sphere{1}), Shape(Box{Vec3(1, 2, 3)}), Shape(Capsule{1, 2}),
                             Shape(Cylinder{1, 2}), Shape(Cone{1, 2}), Shape(Ellipsoid{Vec3(1, 2, 3)}),
                             Shape(HalfSpace{Vec3::UnitZ(), 1}), Shape(Cavity{1}), Shape(hull)})
    EXPECT_TRUE(do_share(shape_of(shape), shape_of(shape))) << shape_type_name(shape);
}

TEST(BodyShapes, WhateverDiffersIsKeptApart) {
  const BodyShape ball = shape_of(Sphere{1});
  BodyShape other = ball;
  other.shape = Sphere{2};
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.shape = Cavity{1};
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.X_BS.p.y() = 0.1;
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.X_BS.p.y() = -0.0;  // Would change the signs of zeros.
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.X_BS.R = Vec3(-1, -1, 1).asDiagonal();
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.material = 1;
  EXPECT_FALSE(do_share(ball, other));
  other = ball;
  other.color = "#fff";
  EXPECT_FALSE(do_share(ball, other));
  EXPECT_FALSE(do_share(shape_of(Capsule{1, 2}), shape_of(Capsule{1, 3})));
  EXPECT_FALSE(do_share(shape_of(Box{Vec3(1, 2, 3)}), shape_of(Box{Vec3(1, 2, 4)})));
  EXPECT_FALSE(do_share(shape_of(Convex{tetrahedron()}), shape_of(Convex{tetrahedron()})));
}

TEST(BodyShapes, ASecondShapeIsNoEqualBody) {
  SharedShapes shared;
  const BodyShape ball = shape_of(Sphere{1});
  BodyShapes one = shapes_of(ball), two = shapes_of(ball, 2);
  shared.share(one);
  shared.share(two);
  EXPECT_EQ(one.size(), 1u);
  EXPECT_EQ(two.size(), 2u);
}

TEST(BodyShapes, BodiesOfAModelShareThemAndAreFoundByTheirNames) {
  ModelBuilder builder;
  for (const int i : {3, 1, 2, 0}) {
    BodyDescription body;
    body.name = "ball" + std::to_string(i);
    body.p_WU = Vec3(3 * i, 0, 0);
    body.shapes.emplace_back().shape = Sphere{i == 2 ? 0.5 : 1};
    builder.add_body(body);
  }
  const std::shared_ptr<const Model> model = builder.build();
  EXPECT_EQ(&model->body(0).shapes.all(), &model->body(1).shapes.all());
  EXPECT_EQ(&model->body(0).shapes.all(), &model->body(3).shapes.all());
  EXPECT_EQ(std::get<Sphere>(model->body(2).shapes[0].shape).radius, 0.5);
  EXPECT_EQ(model->find_body("ball3"), 0);
  EXPECT_EQ(model->find_body("ball0"), 3);
  EXPECT_FALSE(model->find_body("ball"));
  EXPECT_FALSE(model->find_body("ball9"));
}

}  // namespace
}  // namespace rigor::body_shapes_test
