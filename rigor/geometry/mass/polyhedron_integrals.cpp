#include "rigor/geometry/mass/polyhedron_integrals.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/rounding.hpp"
#include "rigor/math/compensated_sum.hpp"

#include <cmath>

namespace rigor {

namespace {

/// Roundings allowed to each term of a sum, in the error bounds.
constexpr double kRoundings = 32;

/// Integrals of 1 | x y z | xx yy zz | xy yz zx.
using Terms = Eigen::Array<double, 10, 1>;

/// Ten compensated sums side by side, and the sums of the terms' magnitudes.
class CompensatedTerms {
 public:
  void add(const Terms& terms) {
    const Terms sum = sum_ + terms;
    const Terms terms_part = sum - sum_;
    error_ += (sum_ - (sum - terms_part)) + (terms - terms_part);
    sum_ = sum;
    magnitude_ += terms.abs();
  }
  Terms value() const { return sum_ + error_; }
  const Terms& magnitude() const { return magnitude_; }

 private:
  Terms sum_ = Terms::Zero();
  Terms error_ = Terms::Zero();
  Terms magnitude_ = Terms::Zero();
};

/// Vertices from the mean of the faces' corners. A vertex that no face uses does not count.
struct CenteredVertices {
  Vec3 origin;
  std::vector<Vec3> points;
};

template <class Faces>  // of triangles or of polygons
CenteredVertices centered(const std::vector<Vec3>& vertices, const Faces& faces) {
  Vec3 sum = Vec3::Zero();
  std::size_t count = 0;
  for (const auto& face : faces) {
    for (const int v : face) sum += vertices[at(v)];
    count += face.size();
  }
  CenteredVertices result{count > 0 ? Vec3(sum / static_cast<double>(count)) : Vec3::Zero(), {}};
  result.points.reserve(vertices.size());
  for (const Vec3& vertex : vertices) result.points.push_back(vertex - result.origin);
  return result;
}

/// Integrals of the monomials over a face's projection on the (a, b) plane.
struct ProjectionIntegrals {
  double one = 0, a = 0, b = 0, aa = 0, ab = 0, bb = 0, aaa = 0, aab = 0, abb = 0, bbb = 0;
};

/// Adds the edge (a0, b0) -> (a1, b1), still without the constant factors of `finished`. Letters as in
/// Mirtich's paper.
void add_edge(double a0, double b0, double a1, double b1, ProjectionIntegrals& P) {
  // Powers and products of the ends.
  const double da = a1 - a0, db = b1 - b0;
  const double a0_2 = a0 * a0, a0_3 = a0_2 * a0, b0_2 = b0 * b0, b0_3 = b0_2 * b0;
  const double a1_2 = a1 * a1, a1_3 = a1_2 * a1, b1_2 = b1 * b1, b1_3 = b1_2 * b1;
  const double a01 = a1 * a0, b01 = b1 * b0;

  // Mirtich's polynomials of the two ends for each monomial on the edge.
  const double C1 = a1 + a0;
  const double Ca = a1 * C1 + a0_2;
  const double Caa = a1 * Ca + a0_3;
  const double Caaa = a1 * Caa + a0_3 * a0;
  const double Cb = b1 * (b1 + b0) + b0_2;
  const double Cbb = b1 * Cb + b0_3;
  const double Cbbb = b1 * Cbb + b0_3 * b0;
  const double Cab = 3 * a1_2 + 2 * a01 + a0_2, Kab = a1_2 + 2 * a01 + 3 * a0_2;
  const double Caab = a0 * Cab + 4 * a1_3, Kaab = a1 * Kab + 4 * a0_3;
  const double Cabb = 4 * b1_3 + 3 * b1_2 * b0 + 2 * b1 * b0_2 + b0_3;
  const double Kabb = b1_3 + 2 * b1_2 * b0 + 3 * b01 * b0 + 4 * b0_3;

  // Green's theorem: monomials with a are integrated along b, those of b alone along a.
  P.one += db * C1;
  P.a += db * Ca;
  P.aa += db * Caa;
  P.aaa += db * Caaa;
  P.b += da * Cb;
  P.bb += da * Cbb;
  P.bbb += da * Cbbb;
  P.ab += db * (b1 * Cab + b0 * Kab);
  P.aab += db * (b1 * Caab + b0 * Kaab);
  P.abb += da * (a1 * Cabb + a0 * Kabb);
}

ProjectionIntegrals finished(const ProjectionIntegrals& P) {
  return {P.one / 2,  P.a / 6,    P.b / -6,   P.aa / 12,   P.ab / 24,
          P.bb / -12, P.aaa / 20, P.aab / 60, P.abb / -60, P.bbb / -20};
}

Vec3 area_normal(const std::vector<Vec3>& points, const std::vector<int>& face) {
  const Vec3& p0 = points[at(face[0])];
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Vec3& p = points[at(face[i])];
    const Vec3& p_next = points[at(face[i + 1])];
    normal += (p - p0).cross(p_next - p0);
  }
  return normal;
}

/// What one polygon adds to the volume integrals: the flux of x, x² .., x³ .., x²y .. through it, with the
/// factors left to the end. The plane is na α + nb β + γ + w = 0: the normal is scaled so that its largest
/// component, along γ, is 1.
Terms face_terms(const std::vector<Vec3>& points, const std::vector<int>& face) {
  // Projection along the largest component γ of the normal: the plane is there a graph over (α, β).
  const Vec3 normal = area_normal(points, face);
  int g;
  if (!(normal.cwiseAbs().maxCoeff(&g) > 0)) return Terms::Zero();
  const int a = (g + 1) % 3, b = (g + 2) % 3;
  const double na = normal[a] / normal[g], nb = normal[b] / normal[g];
  const Vec3& p0 = points[at(face[0])];
  const double w = -(na * p0[a] + nb * p0[b] + p0[g]);

  // Green's theorem takes the projection's integrals to its edges.
  ProjectionIntegrals sums;
  const Vec3* p = &points[at(face[face.size() - 1])];
  for (const int v : face) {
    const Vec3* p_next = &points[at(v)];
    add_edge((*p)[a], (*p)[b], (*p_next)[a], (*p_next)[b], sums);
    p = p_next;
  }
  const ProjectionIntegrals P = finished(sums);

  // ∫γ, ∫γ², ∫γ³, ∫β²γ, ∫γ²α over the projection, by the plane's γ(α, β).
  const double linear = na * P.a + nb * P.b;
  const double square = na * na * P.aa + 2 * na * nb * P.ab + nb * nb * P.bb;
  const double cube =
      na * na * na * P.aaa + 3 * na * na * nb * P.aab + 3 * na * nb * nb * P.abb + nb * nb * nb * P.bbb;
  const double Fc = -(linear + w * P.one);
  const double Fcc = square + w * (2 * linear + w * P.one);
  const double Fccc = -(cube + 3 * w * square + w * w * (3 * linear + w * P.one));
  const double Fbbc = -(na * P.abb + nb * P.bbb + w * P.bb);
  const double Fcca =
      na * na * P.aaa + 2 * na * nb * P.aab + nb * nb * P.abb + w * (2 * (na * P.aa + nb * P.ab) + w * P.a);

  // The fluxes, with the names α, β, γ put back to x, y, z.
  Terms terms;
  terms[0] = a == 0 ? na * P.a : (b == 0 ? nb * P.b : Fc);
  terms[1 + a] = na * P.aa, terms[1 + b] = nb * P.bb, terms[1 + g] = Fcc;
  terms[4 + a] = na * P.aaa, terms[4 + b] = nb * P.bbb, terms[4 + g] = Fccc;
  terms[7 + a] = na * P.aab, terms[7 + b] = nb * Fbbc, terms[7 + g] = Fcca;
  return terms;
}

/// The same for a triangle, where no projection is needed. With N twice its area vector and sums over its
/// corners,
///   ∫ x² dA = |N|/24 (Σx² + (Σx)²),  ∫ x²y dA = |N|/120 ((Σx)² Σy + Σx² Σy + 2 Σx Σxy + 2 Σx²y),  ∫ x³ dA
///   with y = x.
Terms face_terms(const std::vector<Vec3>& points, const std::array<int, 3>& face) {
  const Eigen::Array3d a = points[at(face[0])].array();
  const Eigen::Array3d b = points[at(face[1])].array();
  const Eigen::Array3d c = points[at(face[2])].array();
  const Eigen::Array3d N = (b - a).matrix().cross((c - a).matrix()).array();
  const auto next = [](const Eigen::Array3d& p) {
    return Eigen::Array3d(p[1], p[2], p[0]);
  };  // y for x, z for y, x for z

  // Sums over the corners of the monomials in the formulas.
  const Eigen::Array3d a2 = a * a, b2 = b * b, c2 = c * c;
  const Eigen::Array3d sum = a + b + c, squares = a2 + b2 + c2, cubes = a2 * a + b2 * b + c2 * c;
  const Eigen::Array3d an = next(a), bn = next(b), cn = next(c), sum_n = next(sum);
  const Eigen::Array3d products = a * an + b * bn + c * cn, mixed = a2 * an + b2 * bn + c2 * cn;
  const Eigen::Array3d sum2 = sum * sum;

  Terms terms;
  terms[0] = N[0] * sum[0];
  terms.segment<3>(1) = N * (squares + sum2);
  terms.segment<3>(4) = N * (sum * (sum2 + 3 * squares) + 2 * cubes);
  terms.segment<3>(7) = N * (sum_n * (sum2 + squares) + 2 * (sum * products + mixed));
  return terms;
}

/// Factors of the divergence theorem: x²/2 for ∫x, x³/3 for ∫x², x²y/2 for ∫xy.
Terms face_factors(const PolygonFaces&) {
  Terms factors;
  factors << 1, Vec3::Constant(1.0 / 2), Vec3::Constant(1.0 / 3), Vec3::Constant(1.0 / 2);
  return factors;
}

/// The same times 1/6, 1/24 and 1/120 of the integrals over a triangle.
Terms face_factors(const TriangleFaces&) {
  Terms factors;
  factors << 1.0 / 6, Vec3::Constant(1.0 / 48), Vec3::Constant(1.0 / 360), Vec3::Constant(1.0 / 240);
  return factors;
}

/// Integrals over the tetrahedron from the origin, with the factors 1/6, 1/24, 1/120 left to the end.
Terms tetrahedron_terms(const Vec3& a, const Vec3& b, const Vec3& c) {
  // Six times the signed volume, times the means of the monomials over the corners.
  const double det = a.dot((b - a).cross(c - a));
  const Vec3 s = a + b + c;
  const Vec3 squares = a.cwiseAbs2() + b.cwiseAbs2() + c.cwiseAbs2() + s.cwiseAbs2();
  Terms terms;
  terms << 1, s, squares, a[0] * a[1] + b[0] * b[1] + c[0] * c[1] + s[0] * s[1],
      a[1] * a[2] + b[1] * b[2] + c[1] * c[2] + s[1] * s[2],
      a[2] * a[0] + b[2] * b[0] + c[2] * c[0] + s[2] * s[0];
  return det * terms;
}

Terms tetrahedron_factors() {
  Terms factors;
  factors << 1.0 / 6, Vec3::Constant(1.0 / 24), Eigen::Matrix<double, 6, 1>::Constant(1.0 / 120);
  return factors;
}

PolyhedronIntegrals integrals_of(const Vec3& origin, const Terms& values, const Terms& errors) {
  PolyhedronIntegrals result;
  result.origin = origin;
  result.volume = values[0];
  result.first = values.segment<3>(1);
  const double xy = values[7], yz = values[8], zx = values[9];
  result.second << values[4], xy, zx, xy, values[5], yz, zx, yz, values[6];
  result.volume_error = errors[0];
  result.first_error = errors.segment<3>(1).maxCoeff();
  result.second_error = errors.segment<6>(4).maxCoeff();
  return result;
}

template <class Faces>
CompensatedTerms summed_tetrahedra(const std::vector<Vec3>& points, const Faces& faces) {
  CompensatedTerms sums;
  for (const auto& face : faces) {
    const Vec3& p0 = points[at(face[0])];
    for (std::size_t i = 1; i + 1 < face.size(); ++i) {
      sums.add(tetrahedron_terms(p0, points[at(face[i])], points[at(face[i + 1])]));
    }
  }
  return sums;
}

template <class Faces>
PolyhedronIntegrals integrals_by_faces(const std::vector<Vec3>& vertices, const Faces& faces) {
  // The first method, from the faces, about a point near the solid so that no digits are lost.
  const CenteredVertices centred = centered(vertices, faces);
  CompensatedTerms sums;
  for (const auto& face : faces) sums.add(face_terms(centred.points, face));
  const Terms factors = face_factors(faces);
  const Terms values = sums.value() * factors;
  // The second method, from tetrahedra: the difference of the two shows what rounding bounds cannot, as faces
  // that are not planar.
  const Terms others = summed_tetrahedra(centred.points, faces).value() * tetrahedron_factors();
  const Terms errors = (values - others).abs() + kRoundings * kUnitRoundoff * sums.magnitude() * factors;
  return integrals_of(centred.origin, values, errors);
}

template <class Faces>
PolyhedronIntegrals integrals_by_fans(const std::vector<Vec3>& vertices, const Faces& faces) {
  const CenteredVertices centred = centered(vertices, faces);
  const CompensatedTerms sums = summed_tetrahedra(centred.points, faces);
  return integrals_of(centred.origin, sums.value() * tetrahedron_factors(),
                      kRoundings * kUnitRoundoff * sums.magnitude() * tetrahedron_factors());
}

}  // namespace

PolyhedronIntegrals polyhedron_integrals(const std::vector<Vec3>& vertices, const PolygonFaces& faces) {
  return integrals_by_faces(vertices, faces);
}

PolyhedronIntegrals polyhedron_integrals(const std::vector<Vec3>& vertices, const TriangleFaces& faces) {
  return integrals_by_faces(vertices, faces);
}

PolyhedronIntegrals integrals_by_tetrahedra(const std::vector<Vec3>& vertices, const PolygonFaces& faces) {
  return integrals_by_fans(vertices, faces);
}

PolyhedronIntegrals integrals_by_tetrahedra(const std::vector<Vec3>& vertices, const TriangleFaces& faces) {
  return integrals_by_fans(vertices, faces);
}

}  // namespace rigor
