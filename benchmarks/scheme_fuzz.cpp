// Looks for random scenes that a scheme does not come through: a stop, a state that is no number, energy,
// overlap or joints beyond the audit's tolerances, or no end. usage: rigor_scheme_fuzz [FIRST_SEED [COUNT
// [SCHEME]]]

#include "sim/scheme_fuzz.hpp"
#include "sim/random_scene.hpp"

#include "rigor/sim/method/scheme_check.hpp"
#include "rigor/sim/method/scheme_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include <signal.h>
#include <unistd.h>

namespace {

using namespace rigor;

constexpr double duration = 0.5;     // [s] of a run.
constexpr long most_polls = 250000;  // Of a run, then it is said to take too long.
constexpr unsigned hang = 120;       // [s] after which a run counts as hanging.

unsigned present_seed = 0;
const char* present_scheme = "";

void tell_hang(int) {
  fmt::print("seed {} {}: no answer after {} s\n", present_seed, present_scheme, hang);
  std::fflush(stdout);
  _exit(1);
}

struct Tally {
  std::string name;
  Method method;
  int runs = 0, refused = 0, too_long = 0, troubled = 0;
  double largest_rise = 0;  ///< [J].
};

void run(unsigned seed, const std::shared_ptr<const Model>& model, Tally& tally) {
  if (!check_scheme(*model, tally.method).empty()) {
    ++tally.refused;
    return;
  }
  present_seed = seed;
  present_scheme = tally.name.c_str();
  alarm(hang);
  const test::FuzzOutcome outcome = test::fuzz_run(model, tally.method, duration, most_polls);
  alarm(0);
  ++tally.runs;
  tally.too_long += outcome.took_too_long ? 1 : 0;
  tally.largest_rise = std::max(tally.largest_rise, outcome.energy_rise);
  if (outcome.trouble.empty()) return;
  ++tally.troubled;
  fmt::print("seed {} {}: {}\n", seed, tally.name, outcome.trouble);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const unsigned first = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1;
  const unsigned count = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 200;
  signal(SIGALRM, tell_hang);
  std::vector<Tally> tallies;
  for (const Scheme scheme : all_schemes()) {
    Tally tally;
    tally.method.scheme = scheme;
    tally.name = method_choice(tally.method, "scheme");
    if (argc <= 3 || tally.name == argv[3]) tallies.push_back(tally);
  }
  for (unsigned seed = first; seed < first + count; ++seed) {
    const std::shared_ptr<const Model> model = test::RandomScene(seed).build();
    for (Tally& tally : tallies) run(seed, model, tally);
  }
  int troubled = 0;
  for (const Tally& tally : tallies) {
    troubled += tally.troubled;
    fmt::print("{:<14} {} runs, {} refused, {} too long, {} in trouble, energy rose by {:.3g} J at most\n",
               tally.name, tally.runs, tally.refused, tally.too_long, tally.troubled, tally.largest_rise);
  }
  return troubled == 0 ? 0 : 1;
}
