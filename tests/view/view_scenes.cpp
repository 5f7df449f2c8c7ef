#include "view/view_scenes.hpp"

#include "rigor/math/rotation.hpp"

namespace rigor {

Scene scene_of(const std::string& bodies) {
  return parse_scene("rigor: 1\nname: test\nbodies:\n" + bodies, "test.yaml", ".");
}

std::vector<Pose> start_poses(const Model& model) {
  std::vector<Pose> poses;
  for (const Body& body : model.bodies())
    poses.push_back(Pose{rotation_matrix(body.q_WB), body.p_WB} * body.X_BU);
  return poses;
}

Recording made_up_recording(const Scene& scene, int frames, double dt) {
  Recording recording{scene.model, scene.name, scene.method.contact_tolerance, {}};
  StoredTrajectory& motion = recording.motion;
  for (const Body& body : scene.model->bodies()) motion.bodies.push_back(body.name);
  for (int k = 0; k < frames; ++k) {
    motion.time.push_back(k * dt);
    for (int i = 0; i < scene.model->body_count(); ++i) {
      motion.position.insert(motion.position.end(), {1.0 * i, 0, 1.0 * k});
      motion.orientation.insert(motion.orientation.end(), {1, 0, 0, 0});
      motion.velocity.insert(motion.velocity.end(), {0, 3, 4});
      motion.angular_velocity.insert(motion.angular_velocity.end(), {0, 0, 0.5});
    }
    motion.energy.insert(motion.energy.end(), {1.0 * k, 10.0, 0.5});
    motion.penetration.push_back(0);
  }
  return recording;
}

void add_event(MotionEvent::Kind kind, double time, int a, int b, double impulse, StoredTrajectory& motion) {
  motion.event_time.push_back(time);
  motion.event_kind.push_back(static_cast<int>(kind));
  motion.event_bodies.insert(motion.event_bodies.end(), {a, b});
  motion.event_point.insert(motion.event_point.end(), {0, 0, 0});
  motion.event_impulse.insert(motion.event_impulse.end(), {0, impulse, 0});
}

}  // namespace rigor
