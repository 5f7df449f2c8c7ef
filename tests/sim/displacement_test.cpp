// Bodies that overlap are put apart by the smallest displacement.

#include "rigor/sim/islands/displacement.hpp"

#include "rigor/model/state.hpp"
#include "rigor/sim/islands/contact_system_assembler.hpp"
#include "rigor/sim/pairs/touching_points.hpp"

#include "random_vectors.hpp"
#include "sim/time_stepping_scenes.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rigor::displacement_test {
namespace {

/// A tower of floors of three blocks, each floor across the one below; all heights off by up to `off` [m].
std::shared_ptr<const Model> tower_of(int floors, double off) {
  ModelBuilder builder = test::stepping_builder(0, 0.4, Vec3(0, 0, -9.81));
  test::Random random(5);
  const Vec3 half(0.0375, 0.0125, 0.0075);
  for (int floor = 0; floor < floors; ++floor) {
    for (int k = -1; k <= 1; ++k) {
      const double side = 0.0255 * k, z = 0.0075 + 0.015 * floor + off * random.number();
      const bool is_along_x = floor % 2 == 0;
      const Shape block = Box{is_along_x ? half : Vec3(half.y(), half.x(), half.z())};
      builder.add_body(test::stepping_body("block" + std::to_string(3 * floor + k + 1), block,
                                           is_along_x ? Vec3(0, side, z) : Vec3(side, 0, z)));
    }
  }
  return builder.build();
}

/// The normal rows hold several hundred contacts, of which most say the same: 0 ≤ δ ⊥ gap + A δ ≥ 0 within
/// what the overlaps are known to.
TEST(SeparatingImpulses, PutLargeTowersApart) {
  constexpr double off = 1e-5;
  for (const int floors : {4, 18}) {
    const std::shared_ptr<const Model> model = tower_of(floors, off);
    const Environment environment(*model);
    const ContactSystemAssembler assembler(*model, environment);
    const State state = make_initial_state(*model);

    // Everything that overlaps or is as near as that.
    Cluster tower;
    for (int body = 1; body < model->body_count(); ++body) {
      tower.bodies.push_back(body);
      tower.phases.push_back({state.position(body), state.orientation(body), Vec3::Zero(), Vec3::Zero()});
    }
    const ContactSystem system = assembler.assemble(tower, touching_contacts(*model, state, 2 * off));
    ASSERT_GE(system.contacts.size(), 20u * static_cast<std::size_t>(floors));
    const VecX delta = separating_impulses(system, std::vector<double>(system.contacts.size(), 0.0));

    // Displacements are velocities from rest.
    ContactSystem moved = system;
    for (BodyKinetics& body : moved.kinetics) body.v = body.w = Vec3::Zero();
    apply_impulses(delta, moved);
    double deepest = 0, work = 0;
    for (std::size_t i = 0; i < moved.contacts.size(); ++i) {
      const Contact& contact = moved.contacts[i];
      const double push = delta(3 * static_cast<Eigen::Index>(i) + 2);
      const double gap =
          contact.point.gap + contact.point.n_W.dot(moved.of(contact.body_B).velocity_at(contact.p_W()) -
                                                    moved.of(contact.body_A).velocity_at(contact.p_W()));
      EXPECT_GE(push, 0);
      deepest = std::max(deepest, -gap);
      work += push * gap;
    }
    EXPECT_LE(deepest, 1e-6 * off) << floors;
    EXPECT_NEAR(work, 0, 1e-6 * off * delta.lpNorm<1>()) << floors;
  }
}

}  // namespace
}  // namespace rigor::displacement_test
