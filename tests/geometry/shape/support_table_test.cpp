#include "rigor/geometry/shape/support_table.hpp"

#include "geometry/random_pairs.hpp"

#include <gtest/gtest.h>

namespace rigor::support_table_test {
namespace {

using test::Draw;

TEST(SupportTable, BothScansFindTheSameVertexBitForBit) {
  if (!processor_has_avx2()) GTEST_SKIP() << "this processor has no AVX2";
  Draw draw(1);
  for (const int count : {4, 5, 6, 7, 8, 12, 31, 64, 130}) {
    const ConvexHull hull = std::get<ConvexHull>(make_convex_hull(draw.points(count)));
    for (int i = 0; i < 500; ++i) {
      const Vec3 d = draw.direction();
      EXPECT_EQ(scan_with_avx2(hull.support_table, d), scan_one_by_one(hull.support_table, d));
    }
  }
}

TEST(SupportTable, OfEqualVerticesBothScansTakeTheFirst) {
  if (!processor_has_avx2()) GTEST_SKIP() << "this processor has no AVX2";
  const ConvexHull box = make_box_hull(Vec3(1, 2, 3));
  for (const Vec3& d : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1), Vec3(1, 1, 0)}) {
    const int first = scan_one_by_one(box.support_table, d);
    EXPECT_EQ(scan_with_avx2(box.support_table, d), first);
    for (int i = 0; i < first; ++i) {
      EXPECT_LT(d.dot(box.vertices[static_cast<std::size_t>(i)]),
                d.dot(box.vertices[static_cast<std::size_t>(first)]));
    }
  }
}

TEST(SupportTable, TheWalkFindsWhatTheScanFindsFromAnyStart) {
  Draw draw(2);
  for (const int count : {70, 200, 600}) {
    const ConvexHull hull = std::get<ConvexHull>(make_convex_hull(draw.points(count)));
    ASSERT_FALSE(hull.support_table.starts.empty());
    for (int i = 0; i < 500; ++i) {
      const Vec3 d = draw.uniform(1e-3, 1e3) * draw.direction();
      const int near = static_cast<int>(draw.uniform(0, static_cast<double>(hull.vertices.size())));
      EXPECT_EQ(farthest_vertex(hull.support_table, d, near), scan_one_by_one(hull.support_table, d));
    }
    // The axes and diagonals, at the seams between the patches.
    for (const Vec3& d : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(-1, 1, -1)}) {
      EXPECT_EQ(farthest_vertex(hull.support_table, d, 0), scan_one_by_one(hull.support_table, d));
    }
  }
}

TEST(SupportTable, HoldsTheFacesThatMeetAtEachVertex) {
  Draw draw(3);
  const ConvexHull hull = std::get<ConvexHull>(make_convex_hull(draw.points(40)));
  const SupportTable& table = hull.support_table;
  std::size_t corners = 0;
  for (const std::vector<int>& face : hull.faces) corners += face.size();
  EXPECT_EQ(table.faces.size(), corners);
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    for (int k = table.first_face[v]; k < table.first_face[v + 1]; ++k) {
      const std::vector<int>& face =
          hull.faces[static_cast<std::size_t>(table.faces[static_cast<std::size_t>(k)])];
      EXPECT_EQ(std::count(face.begin(), face.end(), static_cast<int>(v)), 1);
    }
  }
}

}  // namespace
}  // namespace rigor::support_table_test
