// MuJoCo on the reference scenes: soft convex contact.

#include "peer_cases.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <numbers>
#include <stdexcept>

namespace rigor::bench {

namespace {

/// shipped: Euler steps, pyramidal cone, contact as soft as it comes. tuned: RK4, elliptic cone, contact as
/// hard as the step allows.
enum class MujocoSettings { shipped, tuned };

std::string text_of(const Vec3& v) {
  return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z());
}

/// There is no coefficient of restitution: for a bounce without loss contact is a spring without damper that
/// pushes for ten steps.
std::string contact_of(const PeerScene& scene, MujocoSettings settings) {
  if (scene.restitution == 1) {
    const double rate = std::numbers::pi / (10 * scene.step);
    return fmt::format("solref=\"{:.17g} 0\" solimp=\"0.9999 0.9999 0.001\"", -rate * rate);
  }
  if (scene.restitution != 0) throw std::invalid_argument("restitution must be 0 or 1");
  if (settings == MujocoSettings::shipped) return "";
  return fmt::format("solref=\"{:.17g} 1\" solimp=\"0.99 0.9999 0.001\"", 2 * scene.step);
}

std::string options_of(const PeerScene& scene, MujocoSettings settings) {
  const std::string tuned =
      "integrator=\"RK4\" cone=\"elliptic\" impratio=\"100\" noslip_iterations=\"20\" tolerance=\"1e-14\"";
  return fmt::format("<option timestep=\"{:.17g}\" gravity=\"{}\" {}/>\n", scene.step, text_of(scene.gravity),
                     settings == MujocoSettings::tuned ? tuned : "");
}

std::string body_text(const PeerBody& body) {
  std::string shape;
  if (body.shape == PeerBody::Shape::sphere)
    shape = fmt::format("<geom type=\"sphere\" size=\"{:.17g}\"/>", body.half.x());
  if (body.shape == PeerBody::Shape::box)
    shape = fmt::format("<geom type=\"box\" size=\"{}\"/>", text_of(body.half));
  return fmt::format(
      "<body pos=\"{}\"><freejoint/><inertial pos=\"0 0 0\" mass=\"{:.17g}\" diaginertia=\"{}\"/>{}</body>\n",
      text_of(body.p), body.mass, text_of(body.moments), shape);
}

/// The scene in MuJoCo's XML.
std::string scene_text(const PeerScene& scene, MujocoSettings settings) {
  std::string text = "<mujoco>\n" + options_of(scene, settings);
  text += "<size nconmax=\"2000\" njmax=\"8000\"/>\n";
  text += fmt::format("<default><geom condim=\"{}\" friction=\"{:.17g} 0 0\" {}/></default>\n<worldbody>\n",
                      scene.friction > 0 ? 3 : 1, scene.friction, contact_of(scene, settings));
  for (const PeerPlane& plane : scene.planes) {
    text += fmt::format("<geom type=\"plane\" size=\"0 0 1\" zaxis=\"{}\" pos=\"{}\"/>\n", text_of(plane.n),
                        text_of(plane.d * plane.n));
  }
  for (const PeerWall& wall : scene.walls) {
    text += fmt::format("<geom type=\"box\" size=\"{}\" pos=\"{}\"/>\n", text_of(wall.half), text_of(wall.p));
  }
  for (const PeerBody& body : scene.bodies) text += body_text(body);
  return text + "</worldbody>\n</mujoco>\n";
}

mjModel* load(const std::string& text) {
  const std::unique_ptr<mjVFS> files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[0], text.data(), text.size());
  std::string message(1000, '\0');
  mjModel* model = mj_loadXML("scene.xml", files.get(), message.data(), static_cast<int>(message.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error(message.c_str());
  return model;
}

class MujocoWorld : public PeerWorld {
 public:
  MujocoWorld(const PeerScene& scene, MujocoSettings settings);
  void step() override { mj_step(model_.get(), data_.get()); }
  Vec3 position(int body) const override { return Vec3::Map(data_->qpos + 7 * body); }
  Vec3 velocity(int body) const override { return Vec3::Map(data_->qvel + 6 * body); }
  Quat orientation(int body) const override {
    const mjtNum* q = data_->qpos + 7 * body + 3;
    return {q[0], q[1], q[2], q[3]};
  }

 private:
  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_;
};

MujocoWorld::MujocoWorld(const PeerScene& scene, MujocoSettings settings)
    : model_(load(scene_text(scene, settings)), mj_deleteModel),
      data_(mj_makeData(model_.get()), mj_deleteData) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Vec3::Map(data_->qvel + 6 * i) = scene.bodies[i].v;
    Vec3::Map(data_->qvel + 6 * i + 3) = scene.bodies[i].w;
  }
}

Peer make_peer(const std::string& name, MujocoSettings settings) {
  return {name,
          [settings](const PeerScene& scene) { return std::make_unique<MujocoWorld>(scene, settings); }};
}

}  // namespace

std::vector<Row> mujoco_rows() {
  const Peer shipped = make_peer("MuJoCo {}", MujocoSettings::shipped);
  const Peer tuned = make_peer("MuJoCo RK4 {}", MujocoSettings::tuned);
  return {free_top(shipped, 1e-3), free_top(tuned, 1e-2),  free_top(tuned, 1e-3), bounce(tuned, 1e-3),
          bounce(tuned, 1e-4),     block_sticks(shipped),  block_sticks(tuned),   block_slides(shipped),
          block_slides(tuned),     slide_to_roll(shipped), slide_to_roll(tuned),  gas(shipped),
          fast_ball(shipped)};
}

}  // namespace rigor::bench
