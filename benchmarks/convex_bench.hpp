#pragma once

#include "rigor/geometry/distance/distance.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/math/pose.hpp"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor::bench {

/// Kinds of shapes, each with the same number of instances.
inline constexpr std::array<const char*, 10> kKindNames{
    "sphere", "box", "capsule", "cylinder", "cone", "ellipsoid", "hull8", "hull32", "hull128", "hull512"};
inline constexpr int kKinds = static_cast<int>(kKindNames.size());
inline constexpr int kInstances = 4;
inline constexpr int kQueriesAPair = 20;

enum class Regime { separated, touching, shallow, deep };
inline constexpr std::array<const char*, 4> kRegimeNames{"separated", "touching", "shallow", "deep"};

/// Two shapes by their numbers (kind · kInstances + instance) at two poses.
struct ConvexQuery {
  int a;
  int b;
  Pose X_WA;
  Pose X_WB;

  int kind_a() const { return a / kInstances; }
  int kind_b() const { return b / kInstances; }
};

/// The same shapes and queries on every machine.
std::vector<Shape> bench_shapes();
/// 20 queries of each of the 55 pairs of kinds.
std::vector<ConvexQuery> bench_queries(const std::vector<Shape>& shapes, Regime regime);

/// The true signed distance, in long double: lower ≤ truth for certain, truth ≤ upper for certain unless the
/// pair overlaps and one is curved (then upper is the best of many starts).
struct ReferenceDistance {
  long double lower;
  long double upper;
};

/// By a minimum-norm search if the pair is apart; over all face normals and edge products if polytopes
/// overlap; else from many directions and those given, the normals that the engines found.
ReferenceDistance reference_distance(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB,
                                     const std::vector<Vec3>& normals);

/// s(n) = min n·b - max n·a for the direction n made unit, in long double.
long double reference_separation(const Vec3& n, const Shape& a, const Pose& X_WA, const Shape& b,
                                 const Pose& X_WB);

/// What an engine says of a pair; no normal and no bounds where it gives none.
struct EngineAnswer {
  struct Bounds {
    double lower;
    double upper;
  };
  double distance;
  std::optional<Vec3> n_W;  ///< From A to B.
  std::optional<Bounds> bounds = std::nullopt;
};

/// An engine with its own copies of the shapes.
struct ConvexEngine {
  std::string name;
  bool is_signed = true;  ///< Else it knows overlapping pairs only.
  std::function<std::optional<EngineAnswer>(const ConvexQuery&)> solve;
};

/// Prints times and bounds of solids of revolution with parallel and nearly parallel axes.
void print_coaxial();

ConvexEngine rigor_engine(const std::vector<Shape>& shapes);
#ifdef RIGOR_BENCH_FCL
ConvexEngine fcl_engine(const std::vector<Shape>& shapes);
#endif
#ifdef RIGOR_BENCH_CCD
ConvexEngine ccd_mpr_engine(const std::vector<Shape>& shapes);
ConvexEngine ccd_epa_engine(const std::vector<Shape>& shapes);
#endif
#ifdef RIGOR_BENCH_BULLET
ConvexEngine bullet_kernel_engine(const std::vector<Shape>& shapes);
#endif

}  // namespace rigor::bench
