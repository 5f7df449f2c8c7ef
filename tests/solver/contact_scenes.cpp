#include "solver/contact_scenes.hpp"

#include <cmath>

namespace rigor::scenes {

Mat3 axes_of(const Vec3& n, double angle) {
  const Vec3 seed = std::abs(n.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 t1 = (seed - seed.dot(n) * n).normalized();
  const Vec3 t2 = n.cross(t1);
  Mat3 axes;
  axes << std::cos(angle) * t1 + std::sin(angle) * t2, std::cos(angle) * t2 - std::sin(angle) * t1, n;
  return axes;
}

Mat3 box_inertia(double mass, const Vec3& size) {
  const Vec3 s = size.cwiseProduct(size);
  return Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal() * (mass / 12);
}

MatX contact_jacobian(const Scene& scene) {
  MatX J = MatX::Zero(3 * static_cast<Eigen::Index>(scene.contacts.size()),
                      6 * static_cast<Eigen::Index>(scene.bodies.size()));
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    const Contact& contact = scene.contacts[i];
    const auto add = [&](int body, double sign) {
      if (body < 0) return;
      const Vec3 r = contact.point - scene.bodies[static_cast<std::size_t>(body)].center;
      Mat3 cross;
      cross << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
      const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
      J.block<3, 3>(row, 6 * body) += sign * contact.axes.transpose();
      J.block<3, 3>(row, 6 * body + 3) -= sign * contact.axes.transpose() * cross;
    };
    add(contact.body_B, 1);
    add(contact.body_A, -1);
  }
  return J;
}

MatX inverse_mass(const Scene& scene) {
  MatX W = MatX::Zero(6 * static_cast<Eigen::Index>(scene.bodies.size()),
                      6 * static_cast<Eigen::Index>(scene.bodies.size()));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Eigen::Index row = 6 * static_cast<Eigen::Index>(i);
    W.block<3, 3>(row, row) = Mat3::Identity() / scene.bodies[i].mass;
    W.block<3, 3>(row + 3, row + 3) = scene.bodies[i].inertia.inverse();
  }
  return W;
}

VecX free_motion(const Scene& scene) {
  VecX V(6 * static_cast<Eigen::Index>(scene.bodies.size()));
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    V.segment<6>(6 * static_cast<Eigen::Index>(i)) << scene.bodies[i].v, scene.bodies[i].omega;
  return V;
}

CoulombProblem problem_of(const Scene& scene) {
  const MatX J = contact_jacobian(scene);
  CoulombProblem problem;
  const MatX A = J * inverse_mass(scene) * J.transpose();
  problem.A = 0.5 * (A + A.transpose());
  problem.b = J * free_motion(scene);
  for (const Contact& contact : scene.contacts) problem.mu.push_back(contact.mu);
  problem.rows.assign(scene.contacts.size(), FrictionRow::cone);
  problem.slips.assign(scene.contacts.size(), Vec2::UnitX());
  return problem;
}

VecX motion_with(const Scene& scene, const VecX& lambda) {
  return free_motion(scene) + inverse_mass(scene) * contact_jacobian(scene).transpose() * lambda;
}

void add_face(Scene& scene, int below, int above, const Vec3& middle, const Vec2& half, int count, double mu,
              double frame_angle) {
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Vec3 offset(half.x() * (2.0 * i / (count - 1) - 1), half.y() * (2.0 * j / (count - 1) - 1), 0);
      scene.contacts.push_back({below, above, middle + offset, axes_of(Vec3::UnitZ(), frame_angle), mu});
    }
}

Scene box_on_plane(int count, double mu, const Vec3& gravity, double frame_angle) {
  const Vec3 size(1.0, 0.8, 0.6);
  Scene scene;
  scene.bodies.push_back({1.0, box_inertia(1.0, size), Vec3(0, 0, 0.3), gravity});
  add_face(scene, -1, 0, Vec3::Zero(), Vec2(0.5, 0.4), count, mu, frame_angle);
  return scene;
}

Scene stack(const std::vector<double>& masses, double mu, double g) {
  Scene scene;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const double height = static_cast<double>(i);
    scene.bodies.push_back(
        {masses[i], box_inertia(masses[i], Vec3::Ones()), Vec3(0, 0, height + 0.5), Vec3(0, 0, -g)});
    add_face(scene, static_cast<int>(i) - 1, static_cast<int>(i), Vec3(0, 0, height), Vec2(0.5, 0.5), 2, mu);
  }
  return scene;
}

}  // namespace rigor::scenes
