#include "mujoco_world.hpp"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cstring>
#include <numbers>
#include <stdexcept>
#include <string>

namespace rigor::bench {

namespace {

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
  if (settings != MujocoSettings::tuned) return "";
  return fmt::format("solref=\"{:.17g} 1\" solimp=\"0.99 0.9999 0.001\"", 2 * scene.step);
}

std::string options_of(const PeerScene& scene, MujocoSettings settings) {
  const char* chosen = "";
  if (settings == MujocoSettings::elliptic) chosen = "cone=\"elliptic\"";
  if (settings == MujocoSettings::tuned)
    chosen =
        "integrator=\"RK4\" cone=\"elliptic\" impratio=\"100\" noslip_iterations=\"20\" tolerance=\"1e-14\"";
  return fmt::format("<option timestep=\"{:.17g}\" gravity=\"{}\" {}/>\n", scene.step, text_of(scene.gravity),
                     chosen);
}

std::string body_text(const PeerBody& body) {
  std::string shape;
  if (body.shape == PeerBody::Shape::sphere)
    shape = fmt::format("<geom type=\"sphere\" size=\"{:.17g}\"/>", body.half.x());
  if (body.shape == PeerBody::Shape::capsule || body.shape == PeerBody::Shape::cylinder)
    shape = fmt::format("<geom type=\"{}\" size=\"{:.17g} {:.17g}\"/>",
                        body.shape == PeerBody::Shape::capsule ? "capsule" : "cylinder", body.half.x(),
                        body.half.z());
  if (body.shape == PeerBody::Shape::box)
    shape = fmt::format("<geom type=\"box\" size=\"{}\"/>", text_of(body.half));
  return fmt::format(
      "<body pos=\"{}\" quat=\"{:.17g} {:.17g} {:.17g} {:.17g}\"><freejoint/><inertial pos=\"0 0 0\" "
      "mass=\"{:.17g}\" diaginertia=\"{}\"/>{}</body>\n",
      text_of(body.p), body.q.w(), body.q.x(), body.q.y(), body.q.z(), body.mass, text_of(body.moments),
      shape);
}

/// The scene in MuJoCo's XML.
std::string scene_text(const PeerScene& scene, MujocoSettings settings) {
  std::string text = "<mujoco>\n" + options_of(scene, settings);
  // Room for eight contacts a body and more in small scenes, of three rows each: MuJoCo allocates a dense
  // matrix of all rows, and of 300 bodies twenty are refused.
  const std::size_t contacts = 500 + 8 * scene.bodies.size();
  text += fmt::format("<size nconmax=\"{}\" njmax=\"{}\"/>\n", contacts, 3 * contacts);
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

}  // namespace

std::unique_ptr<PeerWorld> make_mujoco_world(const PeerScene& scene, MujocoSettings settings) {
  return std::make_unique<MujocoWorld>(scene, settings);
}

}  // namespace rigor::bench
