#pragma once

#include "rigor/io/scene_reader.hpp"
#include "rigor/math/rotation.hpp"
#include "rigor/view/drawn_scene.hpp"
#include "rigor/view/recording.hpp"

#include <string>
#include <vector>

/// Scenes and motions for tests of pictures.
namespace rigor {

inline Scene scene_of(const std::string& bodies) {
  return parse_scene("rigor: 1\nname: test\nbodies:\n" + bodies, "test.yaml", ".");
}

/// User frames at t = 0.
inline std::vector<Pose> start_poses(const Model& model) {
  std::vector<Pose> poses;
  for (const Body& body : model.bodies())
    poses.push_back(Pose{rotation_matrix(body.q_WB), body.p_WB} * body.X_BL);
  return poses;
}

/// A motion of the scene's bodies: body i is at (i, 0, k) and moves at (0, 0, 1) m/s at time k dt.
inline Recording made_up_recording(const Scene& scene, int frames, double dt) {
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

inline void add_event(MotionEvent::Kind kind, double time, int a, int b, double impulse,
                      StoredTrajectory& motion) {
  motion.event_time.push_back(time);
  motion.event_kind.push_back(static_cast<int>(kind));
  motion.event_bodies.insert(motion.event_bodies.end(), {a, b});
  motion.event_point.insert(motion.event_point.end(), {0, 0, 0});
  motion.event_impulse.insert(motion.event_impulse.end(), {0, impulse, 0});
}

inline const std::string two_balls =
    "  - {name: a, mass: 2, position: [0, 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
    "  - {name: b.c, mass: 3, position: [1, 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n";

}  // namespace rigor
