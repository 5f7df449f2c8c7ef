#pragma once

#include "rigor/sim/method/method.hpp"

#include <string>

namespace rigor {

/// A part of a run that one scheme has carried, where `auto` may hand over from one to another.
struct SchemeSpan {
  Scheme scheme = Scheme::event_driven;
  SolverMethod solver = SolverMethod::exact;  ///< Of its steps, where it is time stepping.
  double begin = 0, end = 0;                  ///< [s].
  double energy = 0;                          ///< Mechanical energy of all bodies at its end [J].
  double work = 0;                            ///< Supplied from outside within it [J].
  /// Largest unexplained rise of the energy within it [J]; the Auditor finds it.
  double rise = 0;
  long impacts = 0;       ///< Within it.
  std::string end_cause;  ///< Why it was handed over at its end; empty if it was not.

  /// Whether the span goes on in the other one.
  bool continues_in(const SchemeSpan& later) const {
    return scheme == later.scheme && solver == later.solver && end_cause.empty();
  }
  /// "time-stepping", "time-stepping (substep)".
  std::string name() const;
  /// Appends what follows it at once.
  void add(const SchemeSpan& later);
};

}  // namespace rigor
