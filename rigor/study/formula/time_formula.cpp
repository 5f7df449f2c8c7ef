#include "rigor/study/formula/time_formula.hpp"

#include "rigor/core/input_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/io/scene/scene_reader.hpp"
#include "rigor/study/formula/formula.hpp"

#include <memory>
#include <mutex>
#include <span>

namespace rigor {

namespace {

/// A formula that threads take in turns: muParser reads its variables from fixed places.
struct SharedFormula {
  explicit SharedFormula(const std::string& text) : formula(text) {}
  std::mutex mutex;
  Formula formula;
};

}  // namespace

TimeFunction time_formula(const std::string& text) {
  const auto shared = std::make_shared<SharedFormula>(text);
  for (const std::string& name : shared->formula.names()) {
    if (name != "t")
      throw InputError("formula " + quoted_text(text) + ": " + quoted_text(name) +
                       " is not known; a function of the time has t [s] and pi");
  }
  const std::size_t count = shared->formula.names().size();
  return TimeFunction(TimeFunction::Formula{text, [shared, count](double t) {
                                              const std::scoped_lock lock(shared->mutex);
                                              return shared->formula.value(std::span(&t, count));
                                            }});
}

void use_time_formulas() {
  use_formula_reader(time_formula);
}

}  // namespace rigor
