#pragma once

#include "rigor/core/index.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rigor {

/// What became of a call that names something by its handle. Nothing has changed unless it is `done`.
enum class BulkStatus {
  done,
  no_such_body,        ///< The handle is that of a body that is gone, or of none.
  no_such_joint,       ///< Likewise.
  no_such_material,    ///< Likewise.
  no_such_sensor,      ///< Likewise.
  no_such_coordinate,  ///< The joint has fewer coordinates.
  not_dynamic,         ///< Forces, impulses and velocities are for dynamic bodies.
  not_led,             ///< Places are given to kinematic bodies without a velocity and a path.
  not_finite,          ///< A number is infinite or none.
  in_use,              ///< The material belongs to a shape that is there.
};

/// Names something of a BulkSimulation for as long as it is there: where it is kept, and the how-manieth it
/// is there. The handle of what is gone names nothing, whatever comes into its place. A default one names
/// nothing.
template <class Kind>
struct BulkHandle {
  std::int32_t place = -1;
  std::uint32_t turn = 0;

  bool operator==(const BulkHandle&) const = default;
};
using BodyId = BulkHandle<struct BodyKind>;
using JointId = BulkHandle<struct JointKind>;
using MaterialId = BulkHandle<struct MaterialKind>;
using SensorId = BulkHandle<struct SensorKind>;

/// The world, as an end of a joint.
inline constexpr BodyId world_end{-2, 0};

/// Which handles are valid.
template <class Kind>
class HandleTable {
 public:
  using Id = BulkHandle<Kind>;

  /// The handle of something new in a place where nothing is.
  Id give(int place) {
    if (slots_.size() <= at(place)) slots_.resize(at(place) + 1, {0, false});
    slots_[at(place)].is_there = true;
    return id_of(place);
  }
  /// What is in a place goes.
  void retire(int place) {
    slots_[at(place)].is_there = false;
    ++slots_[at(place)].number;
    full_ = std::min(full_, at(place));
  }
  /// The handle of what is in a place; one that names nothing if nothing is.
  Id id_of(int place) const {
    if (place < 0 || at(place) >= slots_.size() || !slots_[at(place)].is_there) return {};
    return {place, slots_[at(place)].number};
  }
  std::optional<int> place_of(const Id& id) const {
    const bool is_there = id.place >= 0 && id_of(id.place) == id;
    return is_there ? std::optional<int>(id.place) : std::nullopt;
  }
  /// All that are there, by place.
  std::vector<Id> all() const {
    std::vector<Id> ids;
    for (int place = 0; place < static_cast<int>(slots_.size()); ++place)
      if (slots_[at(place)].is_there) ids.push_back(id_of(place));
    return ids;
  }
  /// The lowest place where nothing is.
  int lowest_free() {
    while (full_ < slots_.size() && slots_[full_].is_there) ++full_;
    return static_cast<int>(full_);
  }
  /// Nothing is there any more, and all handles name nothing.
  void retire_all() {
    for (int place = 0; place < static_cast<int>(slots_.size()); ++place)
      if (slots_[at(place)].is_there) retire(place);
  }

 private:
  struct Slot {
    std::uint32_t number = 0;
    bool is_there = false;
  };
  std::vector<Slot> slots_;
  std::size_t full_ = 0;  ///< All places before this one are taken.
};

}  // namespace rigor
