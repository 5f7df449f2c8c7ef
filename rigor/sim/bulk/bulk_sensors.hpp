#pragma once

#include "rigor/bulk/broad_phase/box_tree.hpp"
#include "rigor/bulk/state/bulk_bodies.hpp"
#include "rigor/geometry/shape/shape.hpp"
#include "rigor/sim/bulk/bulk_handles.hpp"

#include <cstdint>
#include <vector>

namespace rigor {

/// A shape that tells which bodies touch or overlap it, and pushes none.
struct SensorDescription {
  Shape shape;                       ///< Convex and bounded.
  Pose X_US;                         ///< Pose of the shape on the frame of the user of its body, or in W.
  BodyId body;                       ///< That carries it; a default handle: it stands in W.
  std::uint32_t mask = 0xffffffffu;  ///< It feels bodies whose group has a bit of it.
  bool feels_fixed = false;          ///< Whether it feels fixed bodies too.
};

/// A body came to overlap a sensor in a step, or ceased to.
struct SensorEvent {
  enum class Kind { begin, end };
  Kind kind = Kind::begin;
  SensorId sensor;
  BodyId body;

  bool operator==(const SensorEvent&) const = default;
};

/// The sensors of a BulkSimulation. Overlaps are those of the poses at the end of a step, by the 64-bit
/// distances of rigor/geometry; what passes a sensor within a step is not felt.
class BulkSensors {
 public:
  using BodyTable = HandleTable<BodyKind>;

  SensorId add(SensorDescription description);
  bool remove(const SensorId& sensor);
  /// Bodies that overlap it, by place; null if there is no such sensor.
  const std::vector<BodyId>* overlaps(const SensorId& sensor) const;
  /// What began and ended at the last update, by sensor and place.
  const std::vector<SensorEvent>& events() const { return events_; }
  /// Finds who overlaps now. Sensors whose body is gone go.
  void update(const Model& model, const BulkBodies& bodies, const BodyTable& ids);

 private:
  struct Sensor {
    SensorDescription own;
    std::vector<BodyId> overlaps;
  };
  void box_bodies(const Model& model, const BulkBodies& bodies);
  std::vector<BodyId> find(const Sensor& sensor, const Model& model, const BulkBodies& bodies,
                           const BodyTable& ids);
  void note(int place, const std::vector<BodyId>& now);

  HandleTable<SensorKind> ids_;
  std::vector<Sensor> sensors_;  ///< By place.
  std::vector<SensorEvent> events_;
  BoxTree tree_;  ///< Of boxes around the bodies with bounded shapes.
  std::vector<FloatBox> boxes_;
  std::vector<int> boxed_;      ///< The bodies of the boxes.
  std::vector<int> unbounded_;  ///< Bodies with unbounded shapes.
  Vec3 origin_ = Vec3::Zero();  ///< Of the boxes [m].
  std::vector<int> near_;
};

}  // namespace rigor
