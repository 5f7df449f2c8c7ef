#include "rigor/contact/impact/impact_path.hpp"

#include "rigor/math/dense.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

namespace rigor {

namespace {

/// The path with the point of greatest compression among the others, unless it is one of them.
std::vector<CollisionPoint> with_compression(std::span<const CollisionPoint> path,
                                             const CollisionPoint& compression) {
  std::vector<CollisionPoint> points(path.begin(), path.end());
  const auto after = std::find_if(points.begin(), points.end(), [&](const CollisionPoint& point) {
    return point.lambda.z() >= compression.lambda.z();
  });
  const bool is_there = after != points.end() && after->lambda.z() == compression.lambda.z();
  if (compression.lambda.z() > 0 && !is_there) points.insert(after, compression);
  return points;
}

/// Gives each point the state of the stretch that leads to it.
template <class Sliding>
std::vector<ImpactPathPoint> labelled(const std::vector<CollisionPoint>& points, const Sliding& is_sliding) {
  std::vector<ImpactPathPoint> path;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const CollisionPoint &from = points[k == 0 ? 0 : k - 1],
                         &to = points[k == 0 && k + 1 < points.size() ? 1 : k];
    path.push_back({points[k], from.u.z() + to.u.z() < 0, is_sliding(from, to)});
  }
  return path;
}

std::string_view words_of(char phase) {
  switch (phase) {
    case 'S':
      return "slides";
    case 'B':
      return "slides back";
    case 'K':
      return "sticks";
    case 'U':
      return "starts to slip from rest";
    case '|':
      return "greatest compression";
    case 'r':
      return "compresses again";
    case ';':
      return "the law ends while the bodies approach, a new impact begins";
  }
  return "?";
}

/// Eigenvalues, ascending; what is rounding of the largest counts as zero.
Vec3 principal_values(const Mat3& K) {
  constexpr double rounding = 1e-14;
  Vec3 values = symmetric_eigenvalues(K);
  for (double& value : values) {
    if (value <= rounding * values[2]) value = 0;
  }
  return values;
}

}  // namespace

std::vector<ImpactPathPoint> impact_path_of(std::span<const CollisionPoint> path,
                                            const CollisionOutcome& outcome) {
  return labelled(with_compression(path, outcome.compression),
                  [](const CollisionPoint& from, const CollisionPoint& to) {
                    return !from.u.head<2>().isZero(0) || !to.u.head<2>().isZero(0);
                  });
}

std::vector<ImpactPathPoint> impact_path_of(std::span<const CollisionPoint> path,
                                            const CompliantOutcome& outcome) {
  return labelled(with_compression(path, outcome.compression),
                  [&](const CollisionPoint& from, const CollisionPoint& to) {
                    const double middle = 0.5 * (from.lambda.z() + to.lambda.z());
                    bool slides = false;
                    for (const SlipChange& change : outcome.changes) {
                      if (change.lambda_n <= middle) slides = change.direction != 0;
                    }
                    return slides;
                  });
}

std::string phase_letters(const CompliantOutcome& outcome) {
  constexpr double compressed = 0.5 * std::numbers::pi;
  std::string phases;
  bool is_compressing = true;
  for (const SlipChange& change : outcome.changes) {
    if (is_compressing && change.phase > compressed) phases += '|', is_compressing = false;
    phases += change.direction == 0 ? 'K' : change.direction > 0 ? 'S' : 'B';
  }
  if (is_compressing && !phases.empty()) phases += '|';
  return phases;
}

std::string phases_in_words(std::string_view phases) {
  constexpr std::size_t most_words = 24;
  std::string words;
  for (std::size_t k = 0; k < std::min(phases.size(), most_words); ++k) {
    if (k > 0) words += ", ";
    words += words_of(phases[k]);
  }
  if (phases.size() > most_words) words += ", ...";
  return words.empty() ? "nothing: the bodies do not approach" : words;
}

double condition_number(const Mat3& K) {
  const Vec3 values = principal_values(K);
  return values[0] > 0 ? values[2] / values[0] : std::numeric_limits<double>::infinity();
}

double removable_energy(const Mat3& K, const Vec3& u) {
  if (!(principal_values(K)[0] > 0)) return std::numeric_limits<double>::infinity();
  return 0.5 * u.dot(symmetric_solution(K, u));
}

}  // namespace rigor
