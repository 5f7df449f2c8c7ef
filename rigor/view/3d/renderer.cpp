#include "rigor/view/3d/renderer.hpp"

#include "rigor/core/assert.hpp"
#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/math/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace rigor {

namespace {

/// Part of the polygon before the plane z = near (Sutherland and Hodgman, for one plane).
void clip_before(const std::vector<Vec3>& polygon, double near, std::vector<Vec3>& clipped) {
  clipped.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    if (a.z() >= near) clipped.push_back(a);
    if ((a.z() >= near) != (b.z() >= near)) clipped.push_back(a + (near - a.z()) / (b.z() - a.z()) * (b - a));
  }
}

/// The direction of a smooth face's normal over the picture: affine after division by depth, and given at
/// three of its corners.
void set_smooth_normal(std::span<const PicturePoint, 3> at, std::span<const Vec3, 3> normals,
                       ShadedPrimitive& thing) {
  // Three corners of the picture give the three coefficients of an affine function.
  Mat3 places;
  for (int i = 0; i < 3; ++i) {
    const PicturePoint& point = at[static_cast<std::size_t>(i)];
    places.row(i) << 1, point.x, point.y;
  }
  if (std::abs(places.determinant()) < 1e-6) return;  // Smaller than a pixel: it stays flat.
  // The function is that of the normal times the nearness; its scale is free, so the first corner sets it.
  Mat3 values;
  for (int i = 0; i < 3; ++i)
    values.row(i) =
        at[static_cast<std::size_t>(i)].nearness * normals[static_cast<std::size_t>(i)].transpose();
  const Mat3 affine = places.inverse() * values;
  const double scale = 1 / at[0].nearness;
  thing.is_flat = false;
  thing.normal = (scale * affine.row(0)).transpose().cast<float>();
  thing.along_x = (scale * affine.row(1)).transpose().cast<float>();
  thing.along_y = (scale * affine.row(2)).transpose().cast<float>();
}

/// Bounding box on the picture of the cube around the ball, which holds the outline of the ball.
PictureBox box_around(const Vec3& p_K, double radius, const Projection& projection) {
  const double front = p_K.z() - radius, back = p_K.z() + radius, f = projection.focal_length();
  if (front <= 0) return {-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL};
  const auto low = [&](double x) { return f * std::min((x - radius) / front, (x - radius) / back); };
  const auto high = [&](double x) { return f * std::max((x + radius) / front, (x + radius) / back); };
  return {projection.center_x() + low(p_K.x()), projection.center_x() + high(p_K.x()),
          projection.center_y() + low(p_K.y()), projection.center_y() + high(p_K.y()), 1 / front};
}

/// The number 1, 2 or 5 times a power of ten that is close to the value.
double round_number(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  const double lead = value / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

}  // namespace

Vec3 sun_direction(const Camera& camera, const Vec3& up) {
  const Mat3 axes = camera_axes(camera.target - camera.eye, camera.up);
  return (1.1 * up - 0.65 * axes.col(0) - 0.45 * axes.col(2)).normalized();
}

Image Renderer::draw(const DrawnScene& scene, std::span<const Pose> X_WU, const Camera& camera, int width,
                     int height) {
  RIGOR_ASSERT(static_cast<int>(X_WU.size()) == scene.body_count);
  // Place the shapes, sorted from near to far, in front of the camera.
  const Projection projection(camera, width, height);
  const double distance = (camera.target - camera.eye).norm();
  near_ = 1e-3 * distance;
  place(scene, X_WU, projection.X_KW());

  const Vec3 sun_W = sun_direction(camera, scene.up);
  // Draw the shadow map. It covers everything visible around the centre of the picture and half as much
  // beyond it.
  const double visible = distance * std::tan(0.5 * camera.field_of_view) * std::hypot(width, height) / height;
  const Region region{camera.target, 1.5 * visible};
  opaque_.clear();
  std::copy_if(placed_.begin(), placed_.end(), std::back_inserter(opaque_),
               [](const ShownShape& placed) { return !placed.shape->is_glass; });
  has_glass_ = opaque_.size() < placed_.size();
  shadows_.draw(opaque_, sun_W, region, std::clamp(std::max(width, height) * 4 / 5, 1024, 4096));
  shadows_.set_camera(projection.X_KW());

  // First pass: visibility. Each sample finds the nearest face, ball or plane.
  see_all(projection, width, height);

  // Second pass: shading. Each pixel gets the colour of what its samples see.
  const Mat3& R_KW = projection.X_KW().R;
  const Lighting lighting{(R_KW * sun_W).cast<float>(), (R_KW * scene.up).cast<float>(),
                          static_cast<float>(round_number(0.08 * distance)),
                          static_cast<float>(7 * distance)};
  light_flat_primitives(lighting, primitives_);
  Image image(width, height);
  develop(Shader(projection, primitives_, shadows_, lighting), image);
  return image;
}

void Renderer::place(const DrawnScene& scene, std::span<const Pose> X_WU, const Pose& X_KW) {
  placed_.clear();
  for (const DrawnShape& shape : scene.shapes)
    placed_.push_back({&shape, X_WU[static_cast<std::size_t>(shape.body)] * shape.X_US});
  place_lines(scene, X_WU);
  // Sorting by depth lets near shapes hide far ones before these are drawn.
  const auto depth = [&](const ShownShape& placed) { return X_KW.R.row(2).dot(placed.X_WS.p); };
  std::stable_sort(placed_.begin(), placed_.end(),
                   [&](const ShownShape& a, const ShownShape& b) { return depth(a) < depth(b); });
}

/// Places the lines as thin rods, each as long as it is at this moment.
void Renderer::place_lines(const DrawnScene& scene, std::span<const Pose> X_WU) {
  rods_.clear();
  // The placed shapes keep pointers to the rods, so the vector must not reallocate.
  rods_.reserve(scene.lines.size());
  for (const DrawnLine& line : scene.lines) {
    const auto [from, to] = line.ends(X_WU);
    const double length = (to - from).norm();
    if (!(length > 0)) continue;
    const Cylinder rod{line.radius, length / 2};
    DrawnShape& shape = rods_.emplace_back();
    shape.shape = rod;
    shape.surface = std::make_shared<const Surface>(make_surface(rod));
    shape.box = axis_aligned_box(rod, Pose{});
    shape.radius = std::hypot(rod.radius, rod.half_length);
    shape.color = line.color;
    placed_.push_back({&shape, Pose{frame_with_z((to - from) / length), 0.5 * (from + to)}});
  }
}

void Renderer::see_all(const Projection& projection, int width, int height) {
  primitives_.assign(1, ShadedPrimitive{});
  see(projection, false, width, height);
  if (!has_glass_) return;
  // Glass hides nothing: it has samples of its own, which are laid over the others.
  std::swap(grids_, glass_);
  see(projection, true, width, height);
  std::swap(grids_, glass_);
}

void Renderer::see(const Projection& projection, bool glass, int width, int height) {
  for (SampleGrid& grid : grids_) grid.clear(width, height);
  Occlusion occlusion(grids_, width, height);
  for (const ShownShape& placed : placed_) {
    poll_interrupt();
    if (placed.shape->is_glass != glass) continue;
    if (const Sphere* const sphere = std::get_if<Sphere>(&placed.shape->shape)) {
      see_ball(placed, sphere->radius, projection, occlusion);
    } else if (placed.shape->surface) {
      see_surface(placed, projection, occlusion);
    }
  }
  if (glass) return;
  // Planes come last, because most of their samples are hidden by then; they are never glass.
  for (const ShownShape& placed : placed_) {
    if (const HalfSpace* const plane = std::get_if<HalfSpace>(&placed.shape->shape))
      see_plane(placed, *plane, projection);
  }
}

void Renderer::see_ball(const ShownShape& placed, double radius, const Projection& projection,
                        Occlusion& occlusion) {
  const Vec3 p_K = projection.X_KW() * placed.X_WS.p;
  // Skip balls around or behind the eye, and those that nearer shapes hide.
  if (p_K.norm() <= radius + near_ || p_K.z() <= near_) return;
  const PictureBox box = box_around(p_K, radius, projection);
  if (occlusion.hides(box)) return;
  occlusion.add(box);
  const std::uint32_t id = static_cast<std::uint32_t>(primitives_.size());
  ShadedPrimitive& ball = primitives_.emplace_back();
  ball.kind = ShadedPrimitive::Kind::ball;
  ball.color = placed.shape->color;
  ball.normal = p_K.cast<float>();
  for (SampleGrid& grid : grids_) grid.fill(ViewSpaceBall{p_K, radius}, projection, id);
}

void Renderer::see_plane(const ShownShape& placed, const HalfSpace& plane, const Projection& projection) {
  const Pose X_KS = projection.X_KW() * placed.X_WS;
  const Vec3 normal = X_KS.R * plane.normal;
  const Vec3 p = X_KS * (plane.offset * plane.normal);
  const double offset = normal.dot(p);
  if (offset >= 0) return;  // The eye is inside the solid: the plane is left out so that it hides nothing.
  const std::uint32_t id = static_cast<std::uint32_t>(primitives_.size());
  ShadedPrimitive& ground = primitives_.emplace_back();
  ground.kind = ShadedPrimitive::Kind::plane;
  ground.color = placed.shape->color;
  ground.normal = normal.cast<float>();
  // The pattern of squares lies along these two axes of the plane.
  const Mat3 axes = X_KS.R * frame_with_z(plane.normal);
  ground.along_x = axes.col(0).cast<float>();
  ground.along_y = axes.col(1).cast<float>();
  ground.origin = p.cast<float>();
  ground.height = static_cast<float>(-offset);
  for (SampleGrid& grid : grids_) grid.fill(projection.nearness_of_plane(normal, offset), id);
}

void Renderer::see_surface(const ShownShape& placed, const Projection& projection, Occlusion& occlusion) {
  const Surface& surface = *placed.shape->surface;
  const Pose X_KS = projection.X_KW() * placed.X_WS;
  if (X_KS.p.z() <= -placed.shape->radius) return;
  // Project all vertices and find the bounding box of the shape on the picture.
  points_.clear();
  seen_points_.clear();
  PictureBox box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, 0};
  for (const Vec3& vertex : surface.vertices) {
    const Vec3 p_K = X_KS * vertex;
    points_.push_back(p_K);
    // Faces with points behind the near plane are clipped before they are projected.
    const PicturePoint seen = projection.project(Vec3(p_K.x(), p_K.y(), std::max(p_K.z(), near_)));
    seen_points_.push_back({seen.x, seen.y});
    box = {std::min(box.left, seen.x), std::max(box.right, seen.x), std::min(box.top, seen.y),
           std::max(box.bottom, seen.y), std::max(box.nearness, seen.nearness)};
  }
  // A shape that reaches behind the near plane has no bounded box and is never skipped as hidden.
  if (box.nearness >= 1 / near_) box = {-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL};
  if (occlusion.hides(box)) return;
  occlusion.add(box);
  // Draw the faces that point towards the eye.
  for (const Surface::Face& face : surface.faces) {
    const Vec3 normal = X_KS.R * face.normal;
    const std::size_t first = static_cast<std::size_t>(face.begin);
    const double offset = normal.dot(points_[static_cast<std::size_t>(surface.corners[first])]);
    if (offset >= 0) continue;
    ShadedPrimitive& thing = primitives_.emplace_back();
    thing.kind = ShadedPrimitive::Kind::face;
    thing.color = placed.shape->color;
    thing.normal = normal.cast<float>();
    thing.is_flat = true;
    see_face(surface, face, X_KS, projection);
    fill_all(corners_, projection.nearness_of_plane(normal, offset));
  }
}

/// Writes the corners of the face on the picture to corners_, and the normals of a smooth face to its
/// primitive.
void Renderer::see_face(const Surface& surface, const Surface::Face& face, const Pose& X_KS,
                        const Projection& projection) {
  const auto vertex = [&](int i) { return rigor::at(surface.corners[rigor::at(face.begin + i)]); };
  corners_.clear();
  bool is_before = true;
  for (int i = 0; i < face.count; ++i) {
    corners_.push_back(seen_points_[vertex(i)]);
    is_before = is_before && points_[vertex(i)].z() >= near_;
  }
  // A face that crosses the near plane is clipped; it is shaded flat.
  if (!is_before) {
    std::vector<Vec3> polygon;
    polygon.reserve(rigor::at(face.count));
    for (int i = 0; i < face.count; ++i) polygon.push_back(points_[vertex(i)]);
    clip_before(polygon, near_, clipped_);
    corners_.clear();
    for (const Vec3& p_K : clipped_) {
      const PicturePoint seen = projection.project(p_K);
      corners_.push_back({seen.x, seen.y});
    }
  } else if (face.is_smooth) {
    std::array<PicturePoint, 3> at;
    std::array<Vec3, 3> normals;
    for (int i = 0; i < 3; ++i) {
      at[rigor::at(i)] = projection.project(points_[vertex(i)]);
      normals[rigor::at(i)] = X_KS.R * surface.corner_normals[rigor::at(face.begin + i)];
    }
    set_smooth_normal(at, normals, primitives_.back());
  }
}

void Renderer::fill_all(std::span<const Vec2> corners, const NearnessPlane& plane) {
  if (corners.size() < 3) return;
  const Outline outline(corners);
  const std::uint32_t id = static_cast<std::uint32_t>(primitives_.size() - 1);
  for (SampleGrid& grid : grids_) grid.fill(outline, plane, id);
}

void Renderer::develop(const Shader& shader, Image& image) const {
  std::vector<Color> colors(static_cast<std::size_t>(image.width));
  for (int row = 0; row < image.height; ++row) {
    poll_interrupt();
    color_row(shader, row, colors);
    if (has_glass_) lay_glass(shader, row, colors);
    std::uint8_t* out = image.pixel(0, row);
    for (const Color& color : colors) {
      for (int channel = 0; channel < 3; ++channel) *out++ = shader.srgb(color[channel]);
    }
  }
}

void Renderer::color_row(const Shader& shader, int row, std::span<Color> colors) const {
  std::array<const std::uint32_t*, 4> ids;
  std::array<const float*, 4> nearness;
  for (std::size_t s = 0; s < 4; ++s) ids[s] = grids_[s].ids(row), nearness[s] = grids_[s].nearness(row);
  const float y = static_cast<float>(row);
  for (std::size_t column = 0; column < colors.size(); ++column) {
    std::array<PixelSample, 4> samples;
    for (std::size_t s = 0; s < 4; ++s) {
      const float near = nearness[s][column];
      samples[s] = {near > 0 ? ids[s][column] : 0, near};
    }
    colors[column] = pixel_color(shader, samples, static_cast<float>(column), y);
  }
}

/// Mixes the colour of the nearest glass into the row, sample by sample where it is nearer than what is
/// behind it.
void Renderer::lay_glass(const Shader& shader, int row, std::span<Color> colors) const {
  constexpr float share = 0.22F / 4;
  const float y = static_cast<float>(row);
  for (std::size_t s = 0; s < 4; ++s) {
    const std::uint32_t* const ids = glass_[s].ids(row);
    const float *const nearness = glass_[s].nearness(row), *const behind = grids_[s].nearness(row);
    for (std::size_t column = 0; column < colors.size(); ++column) {
      if (!(nearness[column] > std::max(behind[column], 0.0F))) continue;
      const Color pane =
          shader.color(ids[column], static_cast<float>(column) + 0.5F, y + 0.5F, nearness[column]);
      colors[column] += share * (pane - colors[column]);
    }
  }
}

/// Colour of the pixel whose upper left corner is (x, y): the average over its samples, where each visible
/// thing is shaded once, at the mean position of the samples that see it.
Color Renderer::pixel_color(const Shader& shader, const std::array<PixelSample, 4>& samples, float x,
                            float y) const {
  // The common case: all four samples see the same thing.
  if (samples[0].id == samples[1].id && samples[0].id == samples[2].id && samples[0].id == samples[3].id) {
    const float sum = samples[0].nearness + samples[1].nearness + samples[2].nearness + samples[3].nearness;
    return shader.color(samples[0].id, x + 0.5F, y + 0.5F, 0.25F * sum);
  }
  Color color = Color::Zero();
  unsigned waiting = 0b1111;  // Bit mask of the samples that are not shaded yet.
  for (std::size_t s = 0; s < 4; ++s) {
    if (!(waiting >> s & 1U)) continue;
    float count = 0, sum_x = 0, sum_y = 0, sum = 0;
    for (std::size_t k = s; k < 4; ++k) {
      if (samples[k].id != samples[s].id) continue;
      waiting &= ~(1U << k);
      count += 1;
      sum_x += static_cast<float>(grids_[k].offset_x());
      sum_y += static_cast<float>(grids_[k].offset_y());
      sum += samples[k].nearness;
    }
    color += 0.25F * count * shader.color(samples[s].id, x + sum_x / count, y + sum_y / count, sum / count);
  }
  return color;
}

}  // namespace rigor
