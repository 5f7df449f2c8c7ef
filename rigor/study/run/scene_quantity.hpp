#pragma once

#include "rigor/model/state.hpp"
#include "rigor/sim/audit/audit.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A number that a formula of an outcome may name: body.NAME.position (its length, or .x .y .z), .velocity,
/// .angular_velocity, body.NAME.orientation.w (.x .y .z), body.NAME.tilt [rad], joint.NAME.coordinate,
/// joint.NAME.rate ([0], [1], ... behind them if it has several), energy.kinetic (.potential .elastic
/// .total), momentum (.x .y .z), and, at the end of a run, audit. with any number of the audit behind it.
struct SceneQuantity {
  enum class Kind {
    position,
    velocity,
    angular_velocity,
    orientation,
    tilt,
    coordinate,
    rate,
    energy,
    momentum,
    audit
  };
  Kind kind;
  int index = 0;          ///< Of the body or joint; of the part of the energy.
  int component = 0;      ///< x, y, z; -1 for the length; for an orientation w, x, y, z.
  std::string path = {};  ///< Of the audit (audit_quantity.hpp).
};

/// The quantity of that name in a model, or nothing.
std::optional<SceneQuantity> find_quantity(const Model& model, std::string_view name);
/// All names of quantities of a model, to suggest one.
std::vector<std::string> quantity_names(const Model& model);

/// Its value at an output. audit: at the end of a run, else null.
double quantity_value(const SceneQuantity& quantity, const Model& model, const State& state,
                      const Energy& energy, const Audit* audit);

}  // namespace rigor
