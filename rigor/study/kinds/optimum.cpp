#include "rigor/core/index.hpp"
#include "rigor/study/kinds/grid.hpp"
#include "rigor/study/kinds/strategy.hpp"
#include "rigor/study/plan/parameter_values.hpp"
#include "rigor/study/sampling/even_points.hpp"

#include <fmt/format.h>
#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rigor {

namespace {

/// A search of NLopt that is carried out anew each time a value becomes known: it is told the values that it
/// asked for before, and stops where it asks for one that is not known. It is deterministic, so it asks for
/// the same points again; its own arithmetic is nothing beside a run.
class Search {
 public:
  Search(std::vector<double> start, double tolerance, std::size_t most)
      : start_(std::move(start)), tolerance_(tolerance), most_(most) {
    asked_.push_back(start_);
  }

  const std::vector<double>& asked(std::size_t i) const { return asked_[i]; }
  std::size_t asked_count() const { return asked_.size(); }
  bool is_over() const { return is_over_; }

  /// Takes the value of the last point that was asked for, to be minimised, and finds the next.
  void tell(double value) {
    values_.push_back(value);
    replay();
  }
  const std::vector<double>& values() const { return values_; }

 private:
  void replay() {
    next_ = 0;
    // Nelder and Mead's method on subspaces: it takes noise and kinks (Rowan, Functional Stability Analysis
    // of Numerical Algorithms, 1990), within bounds.
    const std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)> search(
        nlopt_create(NLOPT_LN_SBPLX, static_cast<unsigned>(start_.size())), &nlopt_destroy);
    nlopt_set_lower_bounds1(search.get(), 0);
    nlopt_set_upper_bounds1(search.get(), 1);
    nlopt_set_xtol_abs1(search.get(), tolerance_);
    nlopt_set_initial_step1(search.get(), 0.2);
    search_ = search.get();
    nlopt_set_min_objective(search.get(), &Search::objective, this);
    std::vector<double> x = start_;
    double best = 0;
    is_waiting_ = false;
    nlopt_optimize(search.get(), x.data(), &best);
    is_over_ = !is_waiting_;
  }

  static double objective(unsigned count, const double* x, double*, void* self) {
    Search& search = *static_cast<Search*>(self);
    if (search.next_ < search.values_.size()) return search.values_[search.next_++];
    if (!search.is_waiting_ && search.asked_.size() < search.most_) {
      search.asked_.emplace_back(x, x + count);
      search.is_waiting_ = true;
    }
    nlopt_force_stop(search.search_);
    return 0;
  }

  std::vector<double> start_;
  double tolerance_;
  std::size_t most_, next_ = 0;
  std::vector<std::vector<double>> asked_;
  std::vector<double> values_;
  nlopt_opt search_ = nullptr;
  bool is_waiting_ = false, is_over_ = false;
};

/// Minimises (or maximises) the mean of an outcome over `repeats` runs a point, from several starts side by
/// side. A round has one point of each search that goes on.
class Optimum : public Strategy {
 public:
  explicit Optimum(const StudyPlan& plan)
      : plan_(plan), sign_(plan.kind == StudyKind::maximise ? -1 : 1), values_(plan) {
    std::size_t coordinate = 0;
    for (const Parameter& parameter : plan.parameters) {
      if (parameter.kind == Parameter::Kind::interval) searched_.push_back(coordinate);
      coordinate += at(parameter.coordinates());
    }
    const int dimensions = static_cast<int>(searched_.size());
    for (int k = 0; k < plan.starts; ++k) {
      // The first search starts in the middle, others at points that lie evenly.
      std::vector<double> start = k == 0 ? std::vector<double>(searched_.size(), 0.5)
                                         : sobol_point(static_cast<std::uint64_t>(k), dimensions);
      searches_.emplace_back(std::move(start), plan.tolerance, plan.runs);
    }
    ask();
  }

  std::uint64_t most() const override {
    // The product of the three limits is more than 64 bits hold; so many runs are refused anyhow.
    constexpr double most_bits = 0x1p60;
    const double product = static_cast<double>(plan_.runs) * static_cast<double>(plan_.repeats) *
                           static_cast<double>(plan_.starts);
    return static_cast<std::uint64_t>(std::min(product, most_bits));
  }

  std::uint64_t wanted(const RowTable& known) override {
    while (told_ < asked_.size() && known.prefix() >= asked_.size() * plan_.repeats) {
      for (; told_ < asked_.size(); ++told_)
        searches_[asked_[told_].search].tell(sign_ * value_of(known, told_));
      ask();
    }
    return asked_.size() * plan_.repeats;
  }

  std::vector<double> point(std::uint64_t run) const override {
    const Asked& asked = asked_[run / plan_.repeats];
    std::vector<double> point = random_point(plan_, run);
    Grid(plan_).place(0, point);
    const std::vector<double>& x = searches_[asked.search].asked(asked.number);
    for (std::size_t k = 0; k < searched_.size(); ++k) point[searched_[k]] = x[k];
    return point;
  }

  StudyAnswer answer(const RowTable& known) const override {
    StudyAnswer answer;
    const std::vector<std::string> names = plan_.columns();
    const std::string outcome = plan_.outcomes[plan_.main_outcome()].name;
    AnswerFigure figure{
        AnswerFigure::Kind::points, "best " + outcome + " so far", "point", outcome, {}, {}, {}, {}};
    std::size_t best = 0;
    double best_value = std::nan("");
    for (std::size_t i = 0; i < asked_.size() && (i + 1) * plan_.repeats <= known.prefix(); ++i) {
      const double value = value_of(known, i);
      if (std::isfinite(value) && !(sign_ * value >= sign_ * best_value)) best = i, best_value = value;
      figure.x.push_back(static_cast<double>(i)), figure.y.push_back(best_value);
    }
    if (figure.x.empty()) return answer;
    answer.findings.push_back({outcome, best_value, {}, {}, fmt::format("run {}", best * plan_.repeats)});
    const std::vector<double> at_best = values_.at(point(best * plan_.repeats));
    for (std::size_t k = 0; k < names.size(); ++k) answer.findings.push_back({names[k], at_best[k], {}, {}});
    answer.figures.push_back(std::move(figure));
    if (std::any_of(searches_.begin(), searches_.end(),
                    [&](const Search& search) { return search.asked_count() >= plan_.runs; }))
      answer.warnings.push_back("a search ended at the number of runs, not at its tolerance");
    add_warnings(known, answer);
    return answer;
  }

 private:
  struct Asked {
    std::size_t search, number;
  };

  void ask() {
    for (std::size_t k = 0; k < searches_.size(); ++k) {
      if (!searches_[k].is_over()) asked_.push_back({k, searches_[k].asked_count() - 1});
    }
  }

  /// Mean over the runs of a point; worse than any if one of them failed.
  double value_of(const RowTable& known, std::size_t index) const {
    const std::uint64_t first = index * plan_.repeats;
    const std::vector<double> values =
        outcome_values(known, plan_.main_outcome(), first, first + plan_.repeats);
    if (values.size() < plan_.repeats) return sign_ * 1e300;
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(plan_.repeats);
  }

  const StudyPlan& plan_;
  double sign_;
  ParameterValues values_;
  std::vector<std::size_t> searched_;
  std::vector<Search> searches_;
  std::vector<Asked> asked_;
  std::size_t told_ = 0;
};

}  // namespace

std::unique_ptr<Strategy> make_optimum(const StudyPlan& plan) {
  return std::make_unique<Optimum>(plan);
}

}  // namespace rigor
