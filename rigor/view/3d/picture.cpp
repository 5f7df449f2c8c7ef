#include "rigor/view/3d/picture.hpp"

#include "rigor/core/index.hpp"
#include "rigor/core/interrupt.hpp"
#include "rigor/view/3d/canvas.hpp"
#include "rigor/view/3d/sight_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace rigor {

namespace {

constexpr std::size_t most_legend_lines = 8;
constexpr double gap = 10;  ///< Between and around the pictures of a sheet [px].

Color ink() {
  return color_from_hex("#1d2733");
}
Color faint_ink() {
  return color_from_hex("#5b6673");
}
Color paper() {
  return color_from_hex("#ffffff");
}

struct LegendLine {
  std::string name;
  Color color;
};
/// The bodies that can move and are drawn; empty if there are many.
std::vector<LegendLine> legend(const Model& model, const DrawnScene& scene) {
  std::vector<LegendLine> lines;
  int last = -1;
  for (const DrawnShape& shape : scene.shapes) {
    if (!shape.can_move || shape.is_joint || shape.body == last) continue;
    last = shape.body;
    lines.push_back({model.body(last).name, shape.color});
    if (lines.size() > most_legend_lines) return {};
  }
  return lines;
}

/// Size of the text on a picture: readable where the picture is shown small, small where it is large.
double text_size(const PictureSize& size) {
  return std::clamp(0.026 * size.height, 11.0, 40.0);
}

void add_legend(const std::vector<LegendLine>& lines, double x, double y, double size, Canvas& canvas) {
  for (const LegendLine& line : lines) {
    canvas.fill(x, y - 0.62 * size, x + 0.62 * size, y, line.color);
    canvas.text(line.name, x + size, y, {.size = size, .color = ink()});
    y += 1.45 * size;
  }
}

/// Area of the box that the moving shapes cover, each taken as the square around its ball, summed over all
/// moments [px²].
double covered(const PictureBox& box, const DrawnScene& scene, const std::vector<Pose>& poses,
               const Projection& projection) {
  double sum = 0;
  const std::size_t count = at(scene.body_count);
  for (std::size_t first = 0; first + count <= poses.size(); first += count) {
    for (const DrawnShape& shape : scene.shapes) {
      if (!shape.can_move) continue;
      const Vec3 p_K = projection.X_KW() * (poses[first + at(shape.body)] * shape.X_US.p);
      if (p_K.z() <= 0) continue;
      const PicturePoint seen = projection.project(p_K);
      const double r = projection.focal_length() * shape.radius * seen.nearness;
      const double wide = std::min(box.right, seen.x + r) - std::max(box.left, seen.x - r);
      const double high = std::min(box.bottom, seen.y + r) - std::max(box.top, seen.y - r);
      if (wide > 0 && high > 0) sum += wide * high;
    }
  }
  return sum;
}

/// Moments at which the motion is sampled to frame it: all of them, or evenly spaced ones if all would give
/// too many points.
std::vector<Pose> sampled_poses(const Recording& recording) {
  constexpr std::size_t most_poses = 20000;
  const std::size_t n = std::max<std::size_t>(1, recording.motion.bodies.size());
  const std::size_t count = std::clamp<std::size_t>(most_poses / n, 2, 200);
  const std::size_t frames = recording.frame_count(), steps = std::min(count, frames);
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < steps; ++i) {
    poll_interrupt();
    const std::size_t frame = steps > 1 ? i * (frames - 1) / (steps - 1) : 0;
    const std::vector<Pose> here = poses_at(recording, frame);
    poses.insert(poses.end(), here.begin(), here.end());
  }
  return poses;
}

/// Radius of the largest shape that moves [m]; 0 if none does.
double largest_radius(const DrawnScene& scene) {
  double largest = 0;
  for (const DrawnShape& shape : scene.shapes) {
    if (shape.can_move && std::isfinite(shape.radius)) largest = std::max(largest, shape.radius);
  }
  return largest;
}

/// A camera on the way from one to another that looks in the same direction: the distance changes by equal
/// factors.
Camera between(const Camera& from, const Camera& to, double share) {
  Camera camera = from;
  camera.target = from.target + share * (to.target - from.target);
  const Vec3 arm_from = from.eye - from.target, arm_to = to.eye - to.target;
  const double distance = std::pow(arm_from.norm(), 1 - share) * std::pow(arm_to.norm(), share);
  camera.eye = camera.target + distance * arm_from.normalized();
  return camera;
}

}  // namespace

std::string time_text(const Recording& recording, std::size_t frame) {
  const std::vector<double>& time = recording.motion.time;
  const double span = time.back() - time.front();
  const double step = time.size() > 1 && span > 0 ? span / static_cast<double>(time.size() - 1) : 1;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  return fmt::format("t = {:.{}f} s", time[frame], decimals);
}

int sheet_columns(std::size_t count) {
  return count <= 2 ? static_cast<int>(count) : count == 4 ? 2 : 3;
}

PictureSize sheet_tile(int sheet_width) {
  const int width = std::max(least_picture_side, (sheet_width - static_cast<int>(4 * gap)) / 3);
  return {width, std::max(least_picture_side, width * 9 / 16)};
}

PictureRenderer::PictureRenderer(const Recording& recording, const CameraOptions& options,
                                 const PictureSize& size)
    : recording_(recording), size_(size), options_(options), scene_(make_drawn_scene(*recording.model)) {
  const std::vector<Pose> poses = sampled_poses(recording);
  camera_ = make_camera(scene_, poses, options, static_cast<double>(size.width) / size.height);
  glass_ = SightLines(scene_, poses).hiding(camera_.eye);
  place_legend(poses);
}

/// Candidate positions of the legend: below the scene's name, below the time, or in the lower corners.
void PictureRenderer::place_legend(const std::vector<Pose>& poses) {
  const std::vector<LegendLine> lines = legend(*recording_.model, scene_);
  if (lines.empty()) return;
  const double size = text_size(size_), edge = 1.2 * size;
  double widest = 0;
  for (const LegendLine& line : lines) widest = std::max(widest, text_width(line.name, size));
  const double width = 2 * size + widest, height = (1.45 * static_cast<double>(lines.size()) + 0.2) * size;
  const double left = edge - 0.5 * size, right = size_.width - left - width;
  const double top = edge + 1.7 * size, bottom = size_.height - left - height;
  const Projection projection(camera_, size_.width, size_.height);
  double least = HUGE_VAL;
  for (const auto& [x, y] : {std::pair{left, top}, {right, top}, {left, bottom}, {right, bottom}}) {
    const PictureBox box{x, x + width, y, y + height, 0};
    const double hidden = covered(box, scene_, poses, projection);
    if (hidden < least) least = hidden, legend_ = box;
  }
}

void PictureRenderer::put_glass(const std::vector<std::size_t>& shapes) {
  for (DrawnShape& shape : scene_.shapes) shape.is_glass = false;
  for (const std::size_t i : shapes) scene_.shapes[i].is_glass = true;
}

Image PictureRenderer::draw(std::size_t frame, const Camera& camera) {
  // One glass for all pictures of the common camera, so that nothing flickers in a film.
  const std::vector<Pose> poses = poses_at(recording_, frame);
  put_glass(camera.eye == camera_.eye ? glass_ : SightLines(scene_, poses).hiding(camera.eye));
  return renderer_.draw(scene_, poses, camera, size_.width, size_.height);
}

Camera PictureRenderer::camera_of_moment(std::size_t frame) const {
  return shows_nothing(frame) ? own_camera(frame) : camera_;
}

/// Whether the common camera, where it may be left, shows nothing of what moves, or less than a pixel.
bool PictureRenderer::shows_nothing(std::size_t frame) const {
  if (!(largest_radius(scene_) > 0) || options_.eye || options_.target) return false;
  const PictureBox all{0, static_cast<double>(size_.width), 0, static_cast<double>(size_.height), 0};
  const Projection common(camera_, size_.width, size_.height);
  return covered(all, scene_, poses_at(recording_, frame), common) < 1;
}

/// A camera that frames this moment alone, in the direction of the common one.
Camera PictureRenderer::own_camera(std::size_t frame) const {
  CameraOptions options = options_;
  options.forward = (camera_.target - camera_.eye).normalized();
  Camera own = make_camera(scene_, poses_at(recording_, frame), options,
                           static_cast<double>(size_.width) / size_.height);
  // Not so near that the largest body fills the picture and nothing tells where it is.
  constexpr double large = 12;  // Radius [px].
  const double focal_length = Projection(camera_, size_.width, size_.height).focal_length();
  const double distance = (own.eye - own.target).norm();
  const double least =
      std::min((camera_.eye - camera_.target).norm() / 4, focal_length * largest_radius(scene_) / large);
  if (distance < least) own.eye = own.target + least / distance * (own.eye - own.target);
  return own;
}

std::vector<Camera> PictureRenderer::cameras_of_film(std::span<const std::size_t> frames) const {
  constexpr std::ptrdiff_t pan = 30;
  const std::ptrdiff_t count = std::ssize(frames), reach = std::min(pan, count / 4);
  // How much of the own camera a picture has: all where the common one shows nothing, less before and after.
  std::vector<double> shares(frames.size(), 0);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    if (!shows_nothing(frames[at(i)])) continue;
    for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(0, i - reach); k <= std::min(count - 1, i + reach);
         ++k) {
      const double share = 1 - static_cast<double>(std::abs(i - k)) / static_cast<double>(reach + 1);
      shares[at(k)] = std::max(shares[at(k)], share);
    }
  }
  std::vector<Camera> cameras;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    // The pan begins and ends gently.
    const double share = shares[i] * shares[i] * (3 - 2 * shares[i]);
    cameras.push_back(share > 0 ? between(camera_, own_camera(frames[i]), share) : camera_);
  }
  return cameras;
}

Image PictureRenderer::picture(std::size_t frame, const Camera& camera) {
  Image image = draw(frame, camera);
  Canvas canvas(image);
  const double size = text_size(size_), edge = 1.2 * size;
  const double room = size_.width - 2 * edge;
  canvas.text(fitted_text(recording_.name, 1.15 * size, 0.6 * room), edge, edge + size,
              {.size = 1.15 * size, .color = ink()});
  canvas.text(time_text(recording_, frame), size_.width - edge, edge + size,
              {.size = 1.15 * size, .color = ink(), .anchor = Anchor::end});
  if (legend_.right > legend_.left) {
    canvas.fill(legend_.left, legend_.top, legend_.right, legend_.bottom, paper(), 0.6);
    add_legend(legend(*recording_.model, scene_), legend_.left + 0.5 * size, legend_.top + 1.1 * size, size,
               canvas);
  }
  return image;
}

Image PictureRenderer::sheet(const std::vector<KeyMoment>& moments) {
  const double size = std::clamp(0.05 * size_.height, 11.0, 24.0);
  const int columns = sheet_columns(moments.size());
  const int rows = (static_cast<int>(moments.size()) + columns - 1) / columns;
  const int head = static_cast<int>(2.6 * size), caption = static_cast<int>(2 * size);
  const int step_x = size_.width + static_cast<int>(gap), step_y = size_.height + caption;
  Image image(columns * step_x + static_cast<int>(gap), head + rows * step_y);
  Canvas canvas(image);
  canvas.fill(0, 0, image.width, image.height, paper());
  canvas.text(fitted_text(recording_.name, 1.2 * size, image.width - 2 * gap), gap, 0.65 * head,
              {.size = 1.2 * size, .color = ink()});
  double x_legend = image.width - gap;
  const std::vector<LegendLine> lines = legend(*recording_.model, scene_);
  double legend_width = 0;
  for (const LegendLine& line : lines) legend_width += text_width(line.name, size) + 2.4 * size;
  // The legend goes into the head line if there is room for it.
  if (legend_width + text_width(recording_.name, 1.2 * size) + 4 * gap < image.width) {
    x_legend -= legend_width;
    for (const LegendLine& line : lines) {
      add_legend({line}, x_legend, 0.65 * head, size, canvas);
      x_legend += text_width(line.name, size) + 2.4 * size;
    }
  }
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const int x = static_cast<int>(gap) + static_cast<int>(i) % columns * step_x;
    const int y = head + static_cast<int>(i) / columns * step_y;
    const std::size_t frame = moments[i].frame;
    canvas.paste(draw(frame), x, y);
    const std::string time = time_text(recording_, moments[i].frame);
    const double base = y + size_.height + 0.95 * size, from = x + text_width(time, size) + 1.2 * size;
    canvas.text(time, x, base, {.size = size, .color = ink()});
    canvas.text(fitted_text(moments[i].what, size, x + size_.width - from), from, base,
                {.size = size, .color = faint_ink()});
  }
  return image;
}

}  // namespace rigor
