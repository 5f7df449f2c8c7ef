#include "rigor/geometry/shape/support_table.hpp"

#include "rigor/core/index.hpp"
#include "rigor/geometry/shape/convex_hull.hpp"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace rigor {
namespace {

/// Polyhedra with more vertices are searched by walking; measured with rigor_convex_bench.
constexpr int kLargestScan = 64;

double height(const SupportTable& table, const Vec3& d, std::size_t i) {
  return table.x[i] * d.x() + table.y[i] * d.y() + table.z[i] * d.z();
}

int cell(double ratio) {
  const int i = static_cast<int>((ratio + 1) * (0.5 * SupportTable::kGrid));
  return i < SupportTable::kGrid ? i : SupportTable::kGrid - 1;
}

/// The patch of the cube's face that d points at.
int patch_of(const Vec3& d) {
  const double x = std::abs(d.x());
  const double y = std::abs(d.y());
  const double z = std::abs(d.z());
  const int axis = x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2);
  const double largest = axis == 0 ? x : axis == 1 ? y : z;
  const int face = 2 * axis + (d[axis] < 0 ? 1 : 0);
  const double u = d[(axis + 1) % 3] / largest;
  const double v = d[(axis + 2) % 3] / largest;
  return (face * SupportTable::kGrid + cell(u)) * SupportTable::kGrid + cell(v);
}

Vec3 middle_of_patch(int patch) {
  constexpr int n = SupportTable::kGrid;
  const int face = patch / (n * n);
  const int axis = face / 2;
  Vec3 d;
  d[axis] = face % 2 ? -1 : 1;
  d[(axis + 1) % 3] = (2 * (patch / n % n) + 1) / double{n} - 1;
  d[(axis + 2) % 3] = (2 * (patch % n) + 1) / double{n} - 1;
  return d;
}

int scan(const SupportTable& table, const Vec3& d) {
  static const bool has_avx2 = processor_has_avx2();
  return has_avx2 ? scan_with_avx2(table, d) : scan_one_by_one(table, d);
}

/// Goes to the farthest neighbour until none is farther: on a convex polyhedron that is the farthest vertex.
int walk(const SupportTable& table, const Vec3& d, int start) {
  int best = start;
  double best_height = height(table, d, at(best));
  for (int from = -1; from != best;) {
    from = best;
    for (int k = table.first[at(from)]; k < table.first[at(from) + 1]; ++k) {
      const int i = table.neighbours[at(k)];
      const double h = height(table, d, at(i));
      if (h > best_height) {
        best_height = h;
        best = i;
      }
    }
  }
  return best;
}

/// List i goes to row[first[i]] to row[first[i + 1] - 1].
void put_in_a_row(const std::vector<std::vector<int>>& lists, std::vector<int>& first,
                  std::vector<int>& row) {
  for (const std::vector<int>& list : lists) {
    first.push_back(static_cast<int>(row.size()));
    row.insert(row.end(), list.begin(), list.end());
  }
  first.push_back(static_cast<int>(row.size()));
}

}  // namespace

SupportTable make_support_table(const ConvexHull& hull) {
  SupportTable table;
  const std::vector<Vec3>& vertices = hull.vertices;
  table.count = static_cast<int>(vertices.size());
  for (const Vec3& p : vertices) table.extent = std::max(table.extent, p.norm());
  const std::size_t padded = (vertices.size() + 3) / 4 * 4;
  for (std::size_t i = 0; i < padded; ++i) {
    const Vec3& p = vertices[i < vertices.size() ? i : 0];
    table.x.push_back(p.x());
    table.y.push_back(p.y());
    table.z.push_back(p.z());
  }
  // Neighbours and faces of each vertex, one list after the other.
  put_in_a_row(hull.vertex_neighbours, table.first, table.neighbours);
  std::vector<std::vector<int>> vertex_faces(vertices.size());
  for (std::size_t f = 0; f < hull.faces.size(); ++f) {
    for (const int v : hull.faces[f]) vertex_faces[at(v)].push_back(static_cast<int>(f));
  }
  put_in_a_row(vertex_faces, table.first_face, table.faces);
  if (table.count <= kLargestScan) return table;

  // Of large hulls the farthest vertex along the middle of each patch, where a walk begins.
  int start = 0;
  for (int patch = 0; patch < 6 * SupportTable::kGrid * SupportTable::kGrid; ++patch) {
    start = walk(table, middle_of_patch(patch), start);
    table.starts.push_back(start);
  }
  return table;
}

int farthest_vertex(const SupportTable& table, const Vec3& d, int near) {
  if (table.starts.empty()) return scan(table, d);
  const int start = table.starts[at(patch_of(d))];
  const bool is_near_farther = height(table, d, at(near)) > height(table, d, at(start));
  return walk(table, d, is_near_farther ? near : start);
}

int scan_one_by_one(const SupportTable& table, const Vec3& d) {
  int best = 0;
  double best_height = height(table, d, 0);
  for (int i = 1; i < table.count; ++i) {
    const double h = height(table, d, at(i));
    if (h > best_height) {
      best_height = h;
      best = i;
    }
  }
  return best;
}

#if defined(__x86_64__)

bool processor_has_avx2() {
  return __builtin_cpu_supports("avx2") != 0;
}

/// Each of four lanes finds its first highest vertex; of the lanes the highest, of equals the lowest index.
__attribute__((target("avx2"))) int scan_with_avx2(const SupportTable& table, const Vec3& d) {
  const __m256d dx = _mm256_set1_pd(d.x());
  const __m256d dy = _mm256_set1_pd(d.y());
  const __m256d dz = _mm256_set1_pd(d.z());
  const auto heights = [&](std::size_t i) __attribute__((target("avx2"))) {
    const __m256d xy = _mm256_add_pd(_mm256_mul_pd(_mm256_loadu_pd(&table.x[i]), dx),
                                     _mm256_mul_pd(_mm256_loadu_pd(&table.y[i]), dy));
    return _mm256_add_pd(xy, _mm256_mul_pd(_mm256_loadu_pd(&table.z[i]), dz));
  };
  // Four running maxima with the vertex of each.
  __m256d highest = heights(0);
  __m256d index = _mm256_set_pd(3, 2, 1, 0);
  __m256d best = index;
  for (std::size_t i = 4; i < table.x.size(); i += 4) {
    const __m256d h = heights(i);
    const __m256d is_higher = _mm256_cmp_pd(h, highest, _CMP_GT_OQ);
    index = _mm256_add_pd(index, _mm256_set1_pd(4));
    highest = _mm256_blendv_pd(highest, h, is_higher);
    best = _mm256_blendv_pd(best, index, is_higher);
  }
  // The padding is vertex 0 again: it never is higher than the first lane.
  __m256d top = _mm256_max_pd(highest, _mm256_permute_pd(highest, 0b0101));
  top = _mm256_max_pd(top, _mm256_permute2f128_pd(top, top, 1));
  const __m256d is_top = _mm256_cmp_pd(highest, top, _CMP_EQ_OQ);
  __m256d lowest = _mm256_blendv_pd(_mm256_set1_pd(0x1p52), best, is_top);
  lowest = _mm256_min_pd(lowest, _mm256_permute_pd(lowest, 0b0101));
  lowest = _mm256_min_pd(lowest, _mm256_permute2f128_pd(lowest, lowest, 1));
  return static_cast<int>(_mm256_cvtsd_f64(lowest));
}

#else

bool processor_has_avx2() {
  return false;
}

int scan_with_avx2(const SupportTable& table, const Vec3& d) {
  return scan_one_by_one(table, d);
}

#endif

}  // namespace rigor
