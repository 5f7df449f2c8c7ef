#include "solver/heap_problems.hpp"

#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace rigor::heaps {

using Eigen::Index;

namespace {

constexpr double kGravity = 9.81, kStep = 0.01, kDensity = 1000, kPitch = 0.2, kBallPitch = 0.21,
                 kRadius = 0.1;

struct Body {
  Vec3 x;
  Vec3 half;  ///< Half sides of a brick; of a ball its radius.
};

class Maker {
 public:
  explicit Maker(const Heap& heap) : heap_(heap), generator_(heap.seed) {}

  MotionProblem make() {
    place_bodies();
    for (const Body& body : bodies_) add_mass(body);
    mu_ = 0.2 + 0.6 * draw();
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      add_floor(static_cast<int>(b));
      for (std::size_t a = 0; a < b; ++a) add_pair(static_cast<int>(a), static_cast<int>(b));
    }
    add_motion();
    return std::move(problem_);
  }

 private:
  double draw() { return static_cast<double>(generator_()) / 4294967296.0; }
  double draw_either() { return 2 * draw() - 1; }
  bool are_balls() const { return heap_.kind == Kind::balls; }

  void place_bodies() {
    if (heap_.kind == Kind::wall) {
      for (int row = 0; row < heap_.layers; ++row)
        for (int i = 0; i < heap_.layers; ++i)
          bodies_.push_back({{kPitch * (i + 0.5 * (row % 2)), 0, 0.05 + 0.1 * row}, {0.1, 0.05, 0.05}});
      return;
    }
    const Vec3 half = are_balls() ? Vec3::Constant(kRadius) : Vec3(0.095, 0.095, 0.05);
    const double pitch = are_balls() ? kBallPitch : kPitch;
    const double height = are_balls() ? std::sqrt(4 * kRadius * kRadius - 0.5 * pitch * pitch) : 0.1;
    for (int layer = 0; layer < heap_.layers; ++layer)
      for (int i = 0; i < heap_.layers - layer; ++i)
        for (int j = 0; j < heap_.layers - layer; ++j)
          bodies_.push_back(
              {{pitch * (i + 0.5 * layer), pitch * (j + 0.5 * layer), half.z() + height * layer}, half});
  }

  void add_mass(const Body& body) {
    constexpr double pi = 3.14159265358979323846;
    const double volume = are_balls() ? 4 * pi / 3 * kRadius * kRadius * kRadius
                                      : 8 * body.half.x() * body.half.y() * body.half.z();
    const double mass = kDensity * volume * (1 + 3 * draw());
    const Vec3 squares = body.half.cwiseAbs2();
    const Vec3 moments =
        are_balls() ? Vec3(0.4 * mass * squares) : Vec3(mass / 3 * (Vec3::Constant(squares.sum()) - squares));
    Mat6 M = Mat6::Zero();
    M.diagonal() << mass, mass, mass, moments;
    problem_.rows.masses.push_back(M);
    problem_.rows.inverse_masses.push_back(M.diagonal().cwiseInverse().asDiagonal());
  }

  void add_floor(int b) {
    const Body& body = bodies_[static_cast<std::size_t>(b)];
    if (body.x.z() > body.half.z() + 1e-9) return;
    const Vec3 below(body.x.x(), body.x.y(), 0);
    if (are_balls()) return add_contact(-1, b, below, Vec3::UnitZ());
    add_face(-1, b, below, body.half.head<2>());
  }

  void add_pair(int a, int b) {
    const Body &A = bodies_[static_cast<std::size_t>(a)], &B = bodies_[static_cast<std::size_t>(b)];
    const Vec3 apart = B.x - A.x;
    if (are_balls()) {
      if (apart.norm() < 2 * kRadius * (1 + 1e-9)) add_contact(a, b, 0.5 * (A.x + B.x), apart.normalized());
      return;
    }
    // What the top of A and the bottom of B have in common.
    if (std::abs(apart.z() - A.half.z() - B.half.z()) > 1e-9) return;
    const Vec2 low = (A.x - A.half).head<2>().cwiseMax((B.x - B.half).head<2>());
    const Vec2 high = (A.x + A.half).head<2>().cwiseMin((B.x + B.half).head<2>());
    if (((high - low).array() < 1e-6).any()) return;
    const Vec2 middle = 0.5 * (low + high);
    add_face(a, b, {middle.x(), middle.y(), A.x.z() + A.half.z()}, 0.5 * (high - low));
  }

  void add_face(int a, int b, const Vec3& middle, const Vec2& half) {
    for (const double x : {-1.0, 1.0})
      for (const double y : {-1.0, 1.0})
        add_contact(a, b, middle + Vec3(x * half.x(), y * half.y(), 0), Vec3::UnitZ());
  }

  /// At p with the normal n from a (-1: the floor) to b.
  void add_contact(int a, int b, const Vec3& p, const Vec3& n) {
    const Vec3 t = n.cross(std::abs(n.x()) < 0.5 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
    Mat3 axes;
    axes << t, n.cross(t), n;
    ContactRows::Sides sides;
    for (const auto& [side, body, sign] : {std::tuple{0, a, -1.0}, std::tuple{1, b, 1.0}}) {
      if (body < 0) continue;
      ContactRows::Side& of_body = sides[static_cast<std::size_t>(side)];
      of_body.node = body;
      of_body.J << sign * axes.transpose(),
          -sign * axes.transpose() * skew(p - bodies_[static_cast<std::size_t>(body)].x);
    }
    problem_.rows.contacts.push_back(sides);
    problem_.laws.mu.push_back(mu_);
    problem_.laws.rows.push_back(FrictionRow::cone);
    problem_.laws.slips.emplace_back(Vec2::Zero());
  }

  void add_motion() {
    VecX V = VecX::Zero(6 * static_cast<Index>(bodies_.size()));
    for (Index k = 0; k < V.size(); ++k) V(k) = heap_.blow * (k % 6 < 3 ? 1 : 5) * draw_either();
    for (Index k = 2; k < V.size(); k += 6) V(k) -= kGravity * kStep;
    problem_.laws.b = contact_rates(problem_.rows, V);
    for (Index row = 2; row < problem_.laws.b.size(); row += 3) {
      const double rate = 0.5 * heap_.blow * draw();
      if (draw() < 1.0 / 3) problem_.laws.b(row) += rate;
    }
  }

  const Heap& heap_;
  std::mt19937 generator_;
  std::vector<Body> bodies_;
  double mu_ = 0;
  MotionProblem problem_;
};

}  // namespace

std::vector<Heap> all_heaps() {
  std::vector<Heap> heaps;
  unsigned seed = 0;
  const auto add = [&](Kind kind, const std::vector<int>& layers, const std::vector<double>& blows) {
    for (const int count : layers)
      for (const double blow : blows) heaps.push_back({kind, count, blow, ++seed});
  };
  add(Kind::wall, {2, 3, 4, 7}, {0.0, 0.01, 0.1, 1.0});
  add(Kind::wall, {11, 16}, {0.0, 0.01});
  add(Kind::pyramid, {2, 3, 4, 5, 6, 7}, {0.0, 0.01, 0.1, 1.0});
  add(Kind::balls, {2, 3, 4, 5}, {0.0, 0.01, 0.1, 1.0});
  return heaps;
}

std::string name_of(const Heap& heap) {
  const std::array<const char*, 3> kinds{"wall", "pyramid", "balls"};
  return kinds[static_cast<std::size_t>(heap.kind)] + (' ' + std::to_string(heap.layers)) + " blow " +
         std::to_string(heap.blow);
}

MotionProblem problem_of(const Heap& heap) {
  return Maker(heap).make();
}

double residual_of(const MotionProblem& problem, const VecX& lambda) {
  const CoulombProblem& laws = problem.laws;
  const VecX w =
      contact_rates(problem.rows, node_accelerations(problem.rows, contact_wrenches(problem.rows, lambda))) +
      laws.b;
  const VecX diagonal = contact_diagonal(problem.rows);
  const double size = std::max(laws.b.cwiseAbs().maxCoeff(), largest_term(problem.rows, lambda));
  double worst = 0;
  for (std::size_t k = 0; k < laws.mu.size(); ++k) {
    const Index row = 3 * static_cast<Index>(k);
    const double rho = 3 / diagonal.segment<3>(row).sum();
    const Vec3 force = lambda.segment<3>(row), x = force - rho * w.segment<3>(row);
    Vec2 friction = x.head<2>();
    const double radius = laws.mu[k] * std::max(0.0, force.z());
    if (friction.norm() > radius) friction *= radius / friction.norm();
    worst = std::max(
        {worst, std::abs(force.z() - std::max(0.0, x.z())) / rho, (force.head<2>() - friction).norm() / rho});
  }
  return worst / size;
}

}  // namespace rigor::heaps
