#include "rigor/view/3d/framing.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/view/3d/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace rigor {

namespace {

constexpr double usual_field_of_view = 30 * M_PI / 180;
constexpr double margin = 0.07;  ///< Share of the picture's half width and height that stays empty.
constexpr double flying_off = 4, most_radii = 100;

/// The extent of a drawn shape: a ball, its vertices, or the corners of its box if it has many.
void add_extent(const DrawnShape& shape, const Pose& X_WU, std::vector<FramedBall>& balls) {
  constexpr std::size_t most_vertices = 400;
  const Pose X_WS = X_WU * shape.X_US;
  if (const Sphere* const sphere = std::get_if<Sphere>(&shape.shape)) {
    balls.push_back({X_WS.p, sphere->radius});
    return;
  }
  if (shape.surface->vertices.size() <= most_vertices) {
    for (const Vec3& vertex : shape.surface->vertices) balls.push_back({X_WS * vertex, 0});
    return;
  }
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [&](int axis) {
      return corner >> axis & 1 ? shape.box.upper[axis] : shape.box.lower[axis];
    };
    balls.push_back({X_WS * Vec3(side(0), side(1), side(2)), 0});
  }
}

double median(std::vector<double> values) {
  const std::size_t middle = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<long>(middle), values.end());
  return values[middle];
}

Vec3 median(const std::vector<Vec3>& points) {
  Vec3 result;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const Vec3& point : points) values.push_back(point[axis]);
    result[axis] = median(std::move(values));
  }
  return result;
}

/// Everything that the picture should contain.
std::vector<FramedBall> framed_balls(const DrawnScene& scene, std::span<const Pose> poses) {
  const std::size_t n = at(scene.body_count);
  const auto is_bounded = [](const DrawnShape& shape) {
    return !std::holds_alternative<HalfSpace>(shape.shape);
  };
  const bool nothing_moves = std::none_of(scene.shapes.begin(), scene.shapes.end(),
                                          [&](const DrawnShape& s) { return s.can_move && is_bounded(s); });
  // Sort the bounded shapes into moving and fixed ones; if nothing moves, all of them count as moving.
  std::vector<Vec3> starts;
  std::vector<const DrawnShape*> moving, fixed;
  for (const DrawnShape& shape : scene.shapes) {
    if (!is_bounded(shape)) continue;
    const bool is_moving = shape.can_move || nothing_moves;
    (is_moving ? moving : fixed).push_back(&shape);
    if (is_moving) starts.push_back(poses[at(shape.body)] * shape.X_US.p);
  }
  if (moving.empty()) return {};

  // How far each moving shape ever gets from the middle of the start.
  const Vec3 middle = median(starts);
  double start_reach = 0, largest = 0;
  std::vector<double> reaches;
  for (const DrawnShape* const shape : moving) {
    poll_interrupt();
    double reach = 0;
    largest = std::max(largest, shape->radius);
    start_reach =
        std::max(start_reach, (poses[at(shape->body)] * shape->X_US.p - middle).norm() + shape->radius);
    for (std::size_t i = at(shape->body); i < poses.size(); i += n)
      reach = std::max(reach, (poses[i] * shape->X_US.p - middle).norm() + shape->radius);
    reaches.push_back(reach);
  }
  // Beyond this distance a body has flown off and would be too small to see.
  const double limit =
      std::min(flying_off * median(reaches), std::max(1.5 * start_reach, most_radii * largest));

  std::vector<FramedBall> balls;
  for (const DrawnShape* const shape : moving) {
    poll_interrupt();
    for (std::size_t i = at(shape->body); i < poses.size(); i += n) {
      if ((poses[i] * shape->X_US.p - middle).norm() <= limit) add_extent(*shape, poses[i], balls);
    }
  }
  for (const DrawnShape* const shape : fixed) {
    const Pose& X_WU = poses[at(shape->body)];
    if ((X_WU * shape->X_US.p - middle).norm() + shape->radius <= limit) add_extent(*shape, X_WU, balls);
  }
  for (const DrawnLine& line : scene.lines) {
    for (std::size_t first = 0; first + n <= poses.size(); first += n) {
      for (const Vec3& end : line.ends(poses.subspan(first, n))) {
        if ((end - middle).norm() <= limit) balls.push_back({end, line.radius});
      }
    }
  }
  return balls;
}

/// Calls f for each ball. A long run of many bodies has millions of them.
template <typename F>
void for_each_ball(std::span<const FramedBall> balls, F f) {
  constexpr std::size_t between_polls = 1 << 16;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (i % between_polls == 0) poll_interrupt();
    f(balls[i]);
  }
}

/// Largest depth e of the eye from which all balls are between two opposite edges of the picture, with t the
/// tangent of half the angle between them.
///
/// In the axes of the camera a ball at (x, ·, z) of radius r is inside the right edge if
///   x - e_x + r √(1 + t²) ≤ (z - e) t,
/// and inside the left one if the same holds with x - e_x reversed; the sum of both has no e_x.
double farthest_depth(const std::vector<FramedBall>& seen, int axis, double t) {
  double upper = -HUGE_VAL, lower = -HUGE_VAL;
  for_each_ball(seen, [&](const FramedBall& ball) {
    const double reach = ball.radius * std::sqrt(1 + t * t) - ball.p_W.z() * t;
    upper = std::max(upper, ball.p_W[axis] + reach), lower = std::max(lower, -ball.p_W[axis] + reach);
  });
  return -0.5 * (upper + lower) / t;
}

/// Position of the eye along an axis of the picture from which the balls reach equally far to both sides.
double centered(const std::vector<FramedBall>& seen, int axis, double depth) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for_each_ball(seen, [&](const FramedBall& ball) {
    low = std::min(low, ball.p_W[axis] - ball.radius), high = std::max(high, ball.p_W[axis] + ball.radius);
  });
  // Bisection: the reach to one side minus the reach to the other decreases as the eye moves.
  for (int halving = 0; halving < 50; ++halving) {
    const double eye = 0.5 * (low + high);
    double least = HUGE_VAL, most = -HUGE_VAL;
    for_each_ball(seen, [&](const FramedBall& ball) {
      const double x = ball.p_W[axis] - eye, z = ball.p_W.z() - depth, r = ball.radius;
      const double reach = r * std::sqrt(std::max(0.0, x * x + z * z - r * r));
      least = std::min(least, (x * z - reach) / (z * z - r * r));
      most = std::max(most, (x * z + reach) / (z * z - r * r));
    });
    (least + most > 0 ? low : high) = eye;
  }
  return 0.5 * (low + high);
}

/// Spread of the balls along two horizontal axes and upwards.
struct Spread {
  Vec3 first, second;                         ///< Horizontal, unit.
  double along_first, along_second, upwards;  ///< Standard deviations [m].
};
Spread spread_of(const std::vector<FramedBall>& balls, const Vec3& up) {
  const Vec3 first = -camera_axes(up, Vec3::UnitY()).col(0), second = up.cross(first);
  Mat3 axes;
  axes << first, second, up;
  const double count = static_cast<double>(balls.size());
  Vec3 mean = Vec3::Zero(), squares = Vec3::Zero();
  for_each_ball(balls, [&](const FramedBall& ball) { mean += axes.transpose() * ball.p_W / count; });
  for_each_ball(balls, [&](const FramedBall& ball) {
    squares += (axes.transpose() * ball.p_W - mean).cwiseAbs2() / count;
    squares += Vec3::Constant(ball.radius * ball.radius / 5 / count);  // Variance of the points of a ball.
  });
  return {first, second, std::sqrt(squares.x()), std::sqrt(squares.y()), std::sqrt(squares.z())};
}

/// Line of sight across the longer side of the ground that the balls cover, slightly rotated. The flatter the
/// balls are spread, the steeper the view from above.
Vec3 line_of_sight(const std::vector<FramedBall>& balls, const Vec3& up) {
  constexpr double degree = M_PI / 180, azimuth = 24 * degree, least_dip = 10 * degree,
                   more_dip = 30 * degree;
  const Spread spread = spread_of(balls, up);
  const bool is_longer_along_second = spread.along_second > 1.01 * spread.along_first;
  const Vec3 level = up.cross(is_longer_along_second ? spread.second : spread.first);
  const double breadth = std::min(spread.along_first, spread.along_second);
  const double height_and_breadth = spread.upwards + breadth;
  const double dip = least_dip + more_dip * (height_and_breadth > 0 ? breadth / height_and_breadth : 0.5);
  const Vec3 turned = std::cos(azimuth) * level + std::sin(azimuth) * level.cross(up);
  return std::cos(dip) * turned - std::sin(dip) * up;
}

/// The direction turned about `up` and dipped further towards the ground, to at most 80 degrees [rad].
Vec3 moved_sight(const Vec3& forward, const Vec3& up, double azimuth, double dip) {
  constexpr double steepest = 80 * M_PI / 180;
  const double now = std::asin(std::clamp(-forward.dot(up), -1.0, 1.0));
  const double then = std::max(now, std::min(now + dip, steepest));
  const Vec3 level = (forward - forward.dot(up) * up).normalized();
  const Vec3 turned = std::cos(azimuth) * level + std::sin(azimuth) * up.cross(level);
  return std::cos(then) * turned - std::sin(then) * up;
}

/// Of directions about the usual one, that from which the least is hidden, unless it is from far off or from
/// behind for little.
Vec3 clear_sight(const DrawnScene& scene, std::span<const Pose> poses, const Vec3& usual,
                 const std::function<Camera(const Vec3&)>& framed) {
  constexpr double degree = M_PI / 180, hardly = 0.02;
  const SightLines lines(scene, poses);
  const Camera first = framed(usual);
  double least = lines.hidden_part(first.eye);
  if (least <= hardly) return usual;
  // What is hidden counts most, then how far the direction is from the usual one, then how small all becomes.
  const double distance = (first.eye - first.target).norm();
  Vec3 best = usual;
  for (const int azimuth : {0, 1, -1, 2, -2, 3, -3, 4}) {
    for (const int dip : {0, 1, 2}) {
      const Vec3 forward = moved_sight(usual, scene.up, 45 * degree * azimuth, 25 * degree * dip);
      const Camera camera = framed(forward);
      const double cost = lines.hidden_part(camera.eye) + 0.07 * std::abs(azimuth) + 0.15 * dip +
                          0.5 * std::max(0.0, (camera.eye - camera.target).norm() / distance - 1);
      if (cost < least) least = cost, best = forward;
    }
  }
  return best;
}

}  // namespace

Camera framing_camera(std::span<const FramedBall> balls, const Vec3& forward, const Vec3& up,
                      double field_of_view, double width_to_height) {
  const Mat3 axes = camera_axes(forward, up);
  std::vector<FramedBall> seen;
  seen.reserve(balls.size());
  for_each_ball(balls, [&](const FramedBall& ball) {
    seen.push_back({axes.transpose() * ball.p_W, ball.radius});
  });
  // Move the eye back until all balls fit both the width and the height.
  const double half_height = std::tan(0.5 * field_of_view) * (1 - margin);
  const double depth =
      std::min(farthest_depth(seen, 0, half_height * width_to_height), farthest_depth(seen, 1, half_height));
  // Look at the mean depth of the balls, with the eye centred.
  double middle = 0;
  for (const FramedBall& ball : seen) middle += ball.p_W.z() / static_cast<double>(seen.size());
  const Vec3 eye = axes * Vec3(centered(seen, 0, depth), centered(seen, 1, depth), depth);
  return {eye, eye + (middle - depth) * axes.col(2), up, field_of_view};
}

Camera make_camera(const DrawnScene& scene, std::span<const Pose> poses, const CameraOptions& options,
                   double width_to_height) {
  std::vector<FramedBall> balls = framed_balls(scene, poses);
  if (balls.empty()) balls.push_back({Vec3::Zero(), 1});
  const double field_of_view = options.field_of_view.value_or(usual_field_of_view);
  const auto framed = [&](const Vec3& along) {
    return framing_camera(balls, along, scene.up, field_of_view, width_to_height);
  };
  Vec3 forward = options.forward.value_or(line_of_sight(balls, scene.up));
  if (!options.forward && !options.eye) forward = clear_sight(scene, poses, forward, framed);
  Camera camera = framed(forward);
  // What the user asked for overrides the framing.
  if (options.target) {
    if (!options.eye) camera.eye += *options.target - camera.target;
    camera.target = *options.target;
  }
  if (options.eye) camera.eye = *options.eye;
  if (camera.eye == camera.target) camera.target += forward;
  return camera;
}

}  // namespace rigor
