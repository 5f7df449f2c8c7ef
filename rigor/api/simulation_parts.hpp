#pragma once

#include "rigor/api/engine.hpp"
#include "rigor/api/simulation.hpp"

#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace rigor {

/// What a Simulation consists of.
struct Simulation::Parts {
  Parts(Scene scene, bool separate) : engine(std::move(scene), separate) {}

  SimulationEngine engine;
  std::vector<BodyLoad> loads;          ///< Given by the caller, for the next advance.
  std::vector<BodyLoad> control_loads;  ///< Given by the controller, until its next instant.
  Controller controller;
  double period = 0;            ///< Of the controller [s].
  bool is_controlling = false;  ///< The controller is at work.

  const State& state() const { return engine.state(); }
  /// Says that bodies may be elsewhere.
  void changed() { are_tables_known = are_queries_known = false; }
  void control(Simulation& simulation);
  /// Throws if the controller is at work.
  void refuse_in_controller(const char* what) const;

  // Indices; they throw InputError.
  int index_of(const BodyReference& body) const;
  int index_of(const JointReference& joint) const;
  /// A body of the kinds that a call is for.
  int dynamic_body(const BodyReference& body, const char* what) const;
  /// A joint with such a coordinate.
  int joint_with(const JointReference& joint, int coordinate) const;
  /// The laws of a coordinate as the scene has them.
  JointAxis laws_of_scene(int joint, int coordinate) const;
  /// Sets what moves a coordinate, in place of all that did.
  void set_motor(const ModelChanges::Axis& motor, double effort);
  /// The motor of the scene moves a coordinate again.
  void release_motor(int joint, int coordinate);
  /// The surface of a material, to be changed.
  ModelChanges::Surface& surface(std::string_view material);
  void load(const BodyLoad& load) { (is_controlling ? control_loads : loads).push_back(load); }

  struct Tables {
    Rows<3> positions, velocities, angular_velocities;
    Rows<4> orientations;
  };
  const Tables& tables();
  const SceneQueries& queries();

 private:
  Tables tables_;
  std::unique_ptr<SceneQueries> queries_;
  bool are_tables_known = false, are_queries_known = false;
};

}  // namespace rigor
