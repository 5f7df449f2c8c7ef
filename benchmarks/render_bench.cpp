// CPU time of a picture: 10,000 boxes in a loose pile and 10,000 balls, 1280 × 720.

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/3d/framing.hpp"
#include "rigor/view/3d/png_file.hpp"
#include "rigor/view/3d/renderer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

namespace {

using namespace rigor;

constexpr int width = 1280, height = 720, frames = 20;

double cpu_milliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Scene pile_of(const std::string& shape) {
  return parse_scene(
      "rigor: 1\nbodies:\n"
      "  - {name: ground, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0}]}\n"
      "  - {name: b, position: [-10, -10, 0.6], mass: 1, shapes: [" +
          shape + "], repeat: {count: [25, 25, 16], spacing: [0.85, 0.85, 0.85], jitter: 0.1}}\n",
      "pile.yaml", ".");
}

void measure(const char* what, const Scene& scene) {
  const DrawnScene drawn = make_drawn_scene(*scene.model);
  std::vector<Pose> poses;
  for (const Body& body : scene.model->bodies())
    poses.push_back(Pose{rotation_matrix(body.q_WB), body.p_WB} * body.X_BU);
  const Camera camera = make_camera(drawn, poses, {}, static_cast<double>(width) / height);
  Renderer renderer;
  Image image = renderer.draw(drawn, poses, camera, width, height);
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) {
    const double begin = cpu_milliseconds();
    image = renderer.draw(drawn, poses, camera, width, height);
    times.push_back(cpu_milliseconds() - begin);
  }
  std::sort(times.begin(), times.end());
  const double begin = cpu_milliseconds();
  const std::size_t bytes = png_bytes(image).size();
  fmt::print("{:<14} {:>6.1f} ms CPU a frame (median of {}; fastest {:.1f}), PNG of {} kB in {:.0f} ms\n",
             what, times[frames / 2], frames, times[0], bytes / 1000, cpu_milliseconds() - begin);
}

}  // namespace

int main() {
  measure("10,000 boxes", pile_of("{type: box, size: [0.6, 0.6, 0.6]}"));
  measure("10,000 balls", pile_of("{type: sphere, radius: 0.3}"));
  return 0;
}
