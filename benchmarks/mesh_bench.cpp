// Mesh against mesh: a knotted torus and a bumpy ball of the same number of triangles. Median CPU times of
// distance (far, near, along a path), of the first contact and of all pairs of triangles that meet; build and
// memory of the trees.

#include "mesh_bench.hpp"
#include "rigor/geometry/decomposition/make_mesh.hpp"
#include "rigor/geometry/distance/mesh_pair.hpp"
#include "rigor/geometry/mesh/triangle_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace rigor;
using bench::PeerMesh;

constexpr double kPi = std::numbers::pi;

/// Closed surface of a grid that runs round in both directions: 2 rows columns triangles.
template <typename Point>
TriangleMesh make_ring_surface(int rows, int columns, const Point& point) {
  TriangleMesh mesh;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j)
      mesh.vertices.push_back(point(2 * kPi * i / rows, 2 * kPi * j / columns));
  }
  const auto vertex = [&](int i, int j) { return (i % rows) * columns + j % columns; };
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

/// Tube of radius 0.25 m about the knot of a (2, 3) torus.
TriangleMesh make_torus_knot(int rows, int columns) {
  const auto centre = [](double u) {
    const double r = 1 + 0.45 * std::cos(3 * u);
    return Vec3(r * std::cos(2 * u), r * std::sin(2 * u), 0.45 * std::sin(3 * u));
  };
  return make_ring_surface(rows, columns, [&](double u, double v) {
    const Vec3 along = (centre(u + 1e-4) - centre(u - 1e-4)).normalized();
    const Vec3 side = along.cross(Vec3::UnitZ()).normalized(), up = side.cross(along);
    return Vec3(centre(u) + 0.25 * (std::cos(v) * side + std::sin(v) * up));
  });
}

/// Ball of radius 1 m with bumps of 0.08 m.
TriangleMesh make_bumpy_ball(int stacks, int segments) {
  TriangleMesh mesh;
  const auto add = [&](double polar, double azimuth) {
    const double r = 1 + 0.08 * std::sin(6 * polar) * std::cos(7 * azimuth);
    mesh.vertices.emplace_back(r * std::sin(polar) * std::cos(azimuth),
                               r * std::sin(polar) * std::sin(azimuth), r * std::cos(polar));
  };
  for (int k = 1; k < stacks; ++k) {
    for (int i = 0; i < segments; ++i) add(kPi * k / stacks, 2 * kPi * i / segments);
  }
  const int north = static_cast<int>(mesh.vertices.size()), south = north + 1;
  add(0, 0);
  add(kPi, 0);
  for (int i = 0; i < segments; ++i) {
    const int j = (i + 1) % segments, last = (stacks - 2) * segments;
    mesh.triangles.push_back({north, i, j});
    for (int k = 0; k + 2 < stacks; ++k) {
      const int a = k * segments + i, b = k * segments + j;
      mesh.triangles.push_back({a, a + segments, b + segments});
      mesh.triangles.push_back({a, b + segments, b});
    }
    mesh.triangles.push_back({south, last + j, last + i});
  }
  return mesh;
}

double seconds_of(const auto& call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Median over the queries of the least time of several passes [µs]; query(k) answers pose k.
double median_microseconds(std::size_t count, int passes, const auto& query) {
  std::vector<double> best(count, 1e9);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t k = 0; k < count; ++k) best[k] = std::min(best[k], seconds_of([&] { query(k); }));
  }
  std::nth_element(best.begin(), best.begin() + static_cast<long>(count / 2), best.end());
  return 1e6 * best[count / 2];
}

Pose random_pose(std::mt19937& engine, double place) {
  std::normal_distribution<double> normal;
  const Quat q = Quat(normal(engine), normal(engine), normal(engine), normal(engine)).normalized();
  return {q.toRotationMatrix(), place * Vec3(normal(engine), normal(engine), normal(engine)).normalized()};
}

/// Poses at which B comes from outside until it is as far from A as asked for.
std::vector<Pose> poses_at_distance(const Mesh& a, const Mesh& b, double least, double most, int count) {
  std::mt19937 engine(5);
  std::vector<Pose> poses;
  while (static_cast<int>(poses.size()) < count) {
    Pose X = random_pose(engine, 6);
    const Vec3 inwards = -X.p.normalized();
    const double wanted = least * std::pow(most / least, static_cast<double>(poses.size()) / count);
    for (int i = 0; i < 200; ++i) {
      const double distance = mesh_pair_distance(a, b, X).distance;
      if (distance <= wanted * 1.01) break;
      X.p += (distance - wanted) * inwards;
    }
    poses.push_back(X);
  }
  return poses;
}

/// Sequences of ten steps of 0.6 degrees and 3 mm, beginning near.
std::vector<Pose> paths(const std::vector<Pose>& starts) {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  std::vector<Pose> poses;
  for (Pose X : starts) {
    const Vec3 axis = Vec3(normal(engine), normal(engine), normal(engine)).normalized();
    const Vec3 step = 0.003 * Vec3(normal(engine), normal(engine), normal(engine)).normalized();
    const Mat3 turn = Eigen::AngleAxisd(0.6 * kPi / 180, axis).toRotationMatrix();
    for (int i = 0; i < 10; ++i) {
      poses.push_back(X);
      X = {turn * X.R, X.p + step};
    }
  }
  return poses;
}

struct Line {
  std::string what;
  double ours, peer;
};

void print(const std::vector<Line>& lines) {
  fmt::print("{:<44} {:>10} {:>10} {:>8}\n", "", "rigor", "FCL", "ratio");
  for (const Line& line : lines)
    fmt::print("{:<44} {:>10.1f} {:>10.1f} {:>8.2f}\n", line.what, line.ours, line.peer,
               line.peer / line.ours);
}

struct Peers {
  std::unique_ptr<PeerMesh> a, b;
};

class MeshBench {
 public:
  MeshBench(TriangleMesh a, TriangleMesh b) {
    const auto shared_a = std::make_shared<const TriangleMesh>(std::move(a));
    const auto shared_b = std::make_shared<const TriangleMesh>(std::move(b));
    a_ = make_mesh(shared_a);
    b_ = make_mesh(shared_b);
    label_ = fmt::format("{}k", shared_a->triangles.size() / 1000);
    add("build, both meshes (ms)", 1e3 * seconds_of([&] {
                                     make_wide_tree(*shared_a, a_.tree->order),
                                         make_wide_tree(*shared_b, b_.tree->order);
                                   }),
        1e3 * seconds_of([&] { make_peers(); }));
    add("tree (bytes a triangle)",
        static_cast<double>(sizeof(WideTree::Node) * a_.tree->wide.nodes.size()) /
            static_cast<double>(shared_a->triangles.size()),
        peers_.a ? peers_.a->bytes() / static_cast<double>(shared_a->triangles.size()) : kNone);
  }

  void run(int pose_count, int passes) {
    const std::vector<Pose> far = poses_at_distance(a_, b_, 0.3, 3, pose_count);
    const std::vector<Pose> near = poses_at_distance(a_, b_, 1e-3, 2e-2, pose_count);
    distances("distance 0.3 to 3 m, cold (us)", far, passes);
    distances("distance 1 to 20 mm, cold (us)", near, passes);
    const std::vector<Pose> path = paths({near.begin(), near.begin() + std::min(pose_count, 20)});
    path_distances(path, passes);
    std::vector<Pose> deep;
    std::mt19937 engine(11);
    for (int i = 0; i < pose_count; ++i) deep.push_back(random_pose(engine, 0.8 + 0.6 * i / pose_count));
    collisions(deep, passes);
    print(lines_);
  }

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  void add(const std::string& what, double ours, double peer) {
    lines_.push_back({label_ + " " + what, ours, peer});
  }
  void make_peers() {
#ifdef RIGOR_BENCH_FCL
    peers_ = {bench::make_fcl_mesh(*a_.mesh), bench::make_fcl_mesh(*b_.mesh)};
#endif
  }
  /// The peer's time, none without a peer.
  double peer_time(std::size_t count, int passes, const auto& query) const {
    return peers_.a ? median_microseconds(count, passes, query) : kNone;
  }

  void distances(const std::string& what, const std::vector<Pose>& poses, int passes) {
    double worst = 0;
    for (const Pose& X : poses) {
      if (peers_.a)
        worst = std::max(worst, std::abs(mesh_pair_distance(a_, b_, X).distance -
                                         peers_.a->distance(Pose{}, *peers_.b, X)));
    }
    add(what,
        median_microseconds(poses.size(), passes,
                            [&](std::size_t k) { sum_ += mesh_pair_distance(a_, b_, poses[k]).distance; }),
        peer_time(poses.size(), passes,
                  [&](std::size_t k) { sum_ += peers_.a->distance(Pose{}, *peers_.b, poses[k]); }));
    fmt::print("{} {}: largest difference {:.1e} m\n", label_, what, worst);
  }

  void path_distances(const std::vector<Pose>& poses, int passes) {
    MeshPairCache cache;
    const double ours = median_microseconds(poses.size(), passes, [&](std::size_t k) {
      if (k % 10 == 0) cache = {};
      sum_ += mesh_pair_distance(a_, b_, poses[k], &cache).distance;
    });
    add("distance along paths (us)", ours, peer_time(poses.size(), passes, [&](std::size_t k) {
          sum_ += peers_.a->distance(Pose{}, *peers_.b, poses[k]);
        }));
  }

  void collisions(const std::vector<Pose>& poses, int passes) {
    std::vector<Pose> meeting;
    std::size_t pairs = 0;
    for (const Pose& X : poses) {
      if (!surfaces_meet(a_, b_, X)) continue;
      meeting.push_back(X);
      pairs += find_meeting_triangles(a_, b_, X).size();
    }
    fmt::print("{} poses with contact, {:.0f} pairs of triangles on average\n", meeting.size(),
               static_cast<double>(pairs) / static_cast<double>(meeting.size()));
    add("first contact (us)",
        median_microseconds(meeting.size(), passes,
                            [&](std::size_t k) { sum_ += surfaces_meet(a_, b_, meeting[k]); }),
        peer_time(meeting.size(), passes,
                  [&](std::size_t k) { sum_ += peers_.a->collides(Pose{}, *peers_.b, meeting[k]); }));
    add("all pairs (us)",
        median_microseconds(meeting.size(), passes,
                            [&](std::size_t k) {
                              sum_ += static_cast<double>(find_meeting_triangles(a_, b_, meeting[k]).size());
                            }),
        peer_time(meeting.size(), passes, [&](std::size_t k) {
          sum_ += static_cast<double>(peers_.a->count_pairs(Pose{}, *peers_.b, meeting[k]));
        }));
  }

  Mesh a_, b_;
  Peers peers_;
  std::string label_;
  std::vector<Line> lines_;
  double sum_ = 0;
};

}  // namespace

int main() {
  fmt::print("Mesh against mesh: knotted torus and bumpy ball\n");
  MeshBench(make_torus_knot(125, 20), make_bumpy_ball(51, 50)).run(60, 5);
  MeshBench(make_torus_knot(500, 70), make_bumpy_ball(188, 187)).run(30, 3);
  return 0;
}
