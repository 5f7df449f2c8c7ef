#pragma once

#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/view/3d/drawn_scene.hpp"
#include "rigor/view/recording/recording.hpp"

#include <string>
#include <vector>

/// Scenes and motions for tests of pictures.
namespace rigor {

Scene scene_of(const std::string& bodies);

/// User frames at t = 0.
std::vector<Pose> start_poses(const Model& model);

/// A motion of the scene's bodies: body i is at (i, 0, k) and moves at (0, 0, 1) m/s at time k dt.
Recording made_up_recording(const Scene& scene, int frames, double dt);

void add_event(MotionEvent::Kind kind, double time, int a, int b, double impulse, StoredTrajectory& motion);

inline const std::string two_balls =
    "  - {name: a, mass: 2, position: [0, 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n"
    "  - {name: b.c, mass: 3, position: [1, 0, 0], shapes: [{type: sphere, radius: 0.1}]}\n";

}  // namespace rigor
