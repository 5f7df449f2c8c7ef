#include "rigor/contact/impact/impact_problem.hpp"
#include "rigor/contact/impact/reflections.hpp"

#include "random_vectors.hpp"
#include "rigor/model/model_builder.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigor::jointed_impact_test {
namespace {

/// A row of boxes of edge 1 on the floor, 1.5 m apart, with ball joints between them, that fall and spin at
/// random.
ContactSystem falling_row(int boxes, test::Random& random) {
  ModelBuilder builder;
  builder.add_material({"m", 1, 0.4, 0});
  BodyDescription floor;
  floor.name = "floor";
  floor.motion = MotionType::fixed;
  floor.shapes.push_back({HalfSpace{Vec3::UnitZ(), 0}, Vec3::Zero(), Quat::Identity(), "m", ""});
  builder.add_body(floor);
  for (int i = 0; i < boxes; ++i) {
    BodyDescription box;
    box.name = "box" + std::to_string(i);
    box.p_WU = Vec3(1.5 * i, 0, 0.5);
    box.shapes.push_back({Box{Vec3(0.5, 0.5, 0.5)}, Vec3::Zero(), Quat::Identity(), "m", ""});
    builder.add_body(box);
    if (i == 0) continue;
    ModelBuilder::JointDescription joint;
    joint.name = "joint" + std::to_string(i);
    joint.type = JointType::ball;
    joint.bodies = {"box" + std::to_string(i - 1), "box" + std::to_string(i)};
    joint.anchors = {Vec3(1.5 * i - 0.75, 0, 0.5)};
    builder.add_joint(joint);
  }
  const std::shared_ptr<const Model> model = builder.build();

  // All stand on the floor by their four corners.
  std::vector<int> bodies = {0}, joints;
  std::vector<BodyKinetics> kinetics = {BodyKinetics{}};
  std::vector<Contact> contacts;
  for (int i = 0; i < boxes; ++i) {
    const Body& body = model->body(i + 1);
    const BodyPhase phase{Vec3(1.5 * i, 0, 0.5), body.q_WB, random.vector() - Vec3(0, 0, 1),
                          0.1 * random.vector()};
    bodies.push_back(i + 1);
    kinetics.push_back(dynamic_kinetics(body, phase));
    if (i > 0) joints.push_back(i - 1);
    for (const Contact& contact :
         find_contacts(*model, 0, i + 1, kinetics[0].pose(), kinetics.back().pose(), 1e-6))
      contacts.push_back(contact);
  }
  const auto equations = std::make_shared<JointSystem>(*model, joints, bodies, kinetics);
  return make_contact_system(*model, std::move(contacts), bodies, kinetics, equations);
}

double residual_of(const ImpactProblem& problem, const CoulombSolution& solution) {
  const CoulombProblem law{problem.A.dense(), problem.u, frictions(problem),
                           std::vector<FrictionRow>(problem.count(), FrictionRow::cone),
                           std::vector<Vec2>(problem.count(), Vec2::Zero())};
  return coulomb_residual(law, solution.lambda, problem.u + law.A * solution.lambda);
}

/// Many contacts of jointed bodies are solved on rows, and solve the law of the dense matrix.
TEST(JointedImpact, SolvesTheLawOnRows) {
  test::Random random(33);
  for (const int boxes : {3, 5, 9}) {
    SCOPED_TRACE(boxes);
    const ContactSystem system = falling_row(boxes, random);
    const ImpactProblem problem =
        make_impact_problem(system, std::vector<double>(system.contacts.size(), 0.0));
    ASSERT_TRUE(problem.jointed_rows && !problem.rows);
    const CoulombSolution solution = solve_cones(problem, problem.u, frictions(problem));
    EXPECT_TRUE(solution.converged);
    EXPECT_EQ(solution.method, "proximal points");
    EXPECT_LE(residual_of(problem, solution), 1e-9);
    EXPECT_LE(energy_change(problem, solution.lambda), 0);
  }
}

/// With restitution no contact approaches afterwards, and no more energy comes back than the coefficient
/// allows.
TEST(JointedImpact, BouncesOffTheFloorTogether) {
  test::Random random(34);
  for (int example = 0; example < 6; ++example) {
    SCOPED_TRACE(example);
    const ContactSystem system = falling_row(3 + example, random);
    const double e = 0.3;
    const ImpactProblem problem = make_impact_problem(system, std::vector<double>(system.contacts.size(), e));
    const ImpactSolution solution = solve_reflections(problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_LE(fastest_approach(problem.u + problem.A * solution.lambda),
              1e-6 * problem.u.cwiseAbs().maxCoeff());
    EXPECT_LE(energy_change(problem, solution.lambda), 0);
  }
}

}  // namespace
}  // namespace rigor::jointed_impact_test
