// A viewer of one's own: at every sixtieth of a second it is handed the pose of each shape. This one draws
// letters; a library of graphics would take the same calls.
#include <rigor/rigor.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace rigor;

namespace {

/// A picture of letters, seen along y: x to the right from -1 to 3 m, z upwards from 0 to 1 m.
class LetterViewer {
 public:
  void begin_frame() { lines_.fill(std::string(64, ' ')); }
  void draw(const Shape& shape, const Pose& X_WS, char letter) {
    // Where its surface is: a ray for each letter could tell; the box around a ball and a box will do.
    const double reach = std::holds_alternative<Sphere>(shape) ? std::get<Sphere>(shape).radius : 0.1;
    for (std::size_t row = 0; row < lines_.size(); ++row) {
      for (std::size_t column = 0; column < lines_[row].size(); ++column) {
        const double x = -1 + 4 * (static_cast<double>(column) + 0.5) / 64;
        const double z = 1 - (static_cast<double>(row) + 0.5) / 16;
        const Vec3 p_S = X_WS.R.transpose() * (Vec3(x, X_WS.p.y(), z) - X_WS.p);
        const bool is_ball = std::holds_alternative<Sphere>(shape);
        const double from_centre = is_ball ? p_S.norm() : p_S.cwiseAbs().maxCoeff();
        if (from_centre <= reach) lines_[row][column] = letter;
      }
    }
  }
  void end_frame() { ++frames_; }
  int frames() const { return frames_; }
  void print() const {
    for (const std::string& line : lines_) std::cout << line << "\n";
  }

 private:
  std::array<std::string, 16> lines_;
  int frames_ = 0;
};

}  // namespace

int main() {
  const Scene scene = parse_scene(R"(
rigor: 1
materials: [{name: rubber, density: 1000, restitution: 0.7, friction: 0.4}]
bodies:
  - {name: floor, motion: static, shapes: [{type: plane, normal: [0, 0, 1], offset: 0, material: rubber}]}
  - {name: ball, position: [-0.8, 0, 0.8], velocity: [1.5, 0, 0], shapes: [{type: sphere, radius: 0.1, material: rubber}]}
  - {name: box, position: [1, 0, 0.1], shapes: [{type: box, size: [0.2, 0.2, 0.2], material: rubber}]}
)",
                                  "viewed.yaml", ".");
  Simulation sim(scene);
  LetterViewer viewer;

  // The hook: called at multiples of the period, whatever the step of the simulation is; it only looks.
  sim.set_controller(
      [&viewer](Simulation& own) {
        viewer.begin_frame();
        for (int i = 0; i < own.body_count(); ++i) {
          const Body& body = own.model().body(i);
          // Shapes lie in the body's frame B; pose() is that of the user's frame.
          const Pose X_WB = own.pose(BodyHandle{i}) * body.X_BU.inverse();
          for (const BodyShape& shape : body.shapes)
            if (body.motion == MotionType::dynamic) viewer.draw(shape.shape, X_WB * shape.X_BS, body.name[1]);
        }
        viewer.end_frame();
      },
      1.0 / 60);
  sim.advance_to(2.0);
  viewer.print();
  std::cout << viewer.frames() << " frames\n";
  return viewer.frames() == 120 && sim.audit().violations.empty() ? 0 : 1;
}
