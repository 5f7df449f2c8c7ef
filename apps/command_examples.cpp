#include "apps/command_pages.hpp"
#include "apps/exit_codes.hpp"

#include <algorithm>
#include <array>

namespace rigor {

namespace {

/// In the order of the commands; the first of each stands in the help of the program, too.
constexpr std::array examples = {
    Example{"run", "rigor run scenes/bouncing_ball.yaml", "run, then print the audit"},
    Example{"run", "rigor run ball.yaml -o ball.html", "the replay as one page for any browser"},
    Example{"run", "rigor run ball.yaml -o ball.h5 -o ball.csv --json audit.json", ""},
    Example{"run",
            "rigor run ball.yaml --set method.integrator=dopri5 --set bodies.ball.velocity=\"[1, 0, 0]\"",
            ""},
    Example{"run", "rigor run long.yaml --checkpoint long.cp --checkpoint-every 10", ""},
    Example{"run", "rigor run long.yaml --resume long.cp --duration 1000", ""},
    Example{"view", "rigor view ball.yaml --open", "live in the browser: change it while it runs"},
    Example{"view", "rigor view ball.h5", "the replay of a trajectory"},
    Example{"compare", "rigor compare ball.yaml --vary method.impact=newton,poisson -o compare.html",
            "side by side"},
    Example{"compare", "rigor compare ball.yaml --vary method.toi=conservative,ratio,bisection", ""},
    Example{"compare", "rigor compare ball.yaml --vary run.step=0.01,0.005,0.0025 -o compare.csv",
            "error and CPU time by step"},
    Example{"study", "rigor study scenes/studies/arch_friction.yaml", "thousands of runs for an answer"},
    Example{"study", "rigor study die.yaml --threads 2 -o die.csv -o die.html",
            "rows, and the answer as a page"},
    Example{"study", "rigor study die.yaml --view --open", "its page, on which a click replays a run"},
    Example{"study", "rigor study die.yaml --run 12 -o run_12.html", "one of its runs once more"},
    Example{"check", "rigor check scenes/*.yaml", "every error of a scene at once"},
    Example{"check", "rigor check pile.yaml --estimate", "what each scheme would cost"},
    Example{"mass", "rigor mass part.stl --density 7850", ""},
    Example{"mass", "rigor mass scene.yaml --json -", "of all its bodies, as JSON"},
    Example{"distance", "rigor distance ball.yaml ball floor", ""},
    Example{"distance", "rigor distance pile.yaml --ray=\"0,0,9 0,0,-1\"", "what a ray hits"},
    Example{"distance", "rigor distance pile.yaml --point 0,0,1 --closest 3",
            "the bodies closest to a point"},
    Example{"convert", "rigor convert gear.stl gear.yaml --exact",
            "a solid as convex pieces, ready for a scene"},
    Example{"convert", "rigor convert part.ply part.obj", "a mesh in another format"},
    Example{"methods", "rigor methods", "all of them"},
    Example{"methods", "rigor methods contact region", "what stands here for a word of the courses"},
    Example{"render", "rigor render ball.h5 --time 0.5 -o ball.png", "one picture"},
    Example{"render", "rigor render ball.yaml", "a sheet of the key moments: ball.png"},
    Example{"render", "rigor render ball.h5 --mp4 ball.mp4", "a film, by the program ffmpeg"},
    Example{"plot", "rigor plot ball.h5 energy.kinetic energy.total body.ball.position.z -o ball.svg", ""},
    Example{"impact", "rigor impact scene.yaml floor box --law stronge --path path.csv", ""},
    Example{"impact", "rigor impact --K=3.5,0,0,3.5,0,1 --u=2,1,-3 --mu 0.2 --e 0.8 -o paths.svg",
            "of a collision matrix and a velocity"},
    Example{"help", "rigor help run", "all about one command"},
    Example{"completion", "source <(rigor completion bash)", "TAB knows commands, options and files"},
    Example{"completion", "rigor completion zsh > ~/.zfunc/_rigor", "a folder of $fpath"},
    Example{"completion", "rigor completion fish > ~/.config/fish/completions/rigor.fish", ""},
    Example{"manual", "rigor manual run | man -l -", "the page where it is not installed"},
};

}  // namespace

std::vector<Example> examples_of(std::string_view command) {
  std::vector<Example> chosen;
  for (const Example& example : examples) {
    const bool is_first = chosen.empty() || chosen.back().command != example.command;
    if (command.empty() ? is_first : example.command == command) chosen.push_back(example);
  }
  return chosen;
}

const std::vector<ExitMeaning>& exit_meanings() {
  static const std::vector<ExitMeaning> meanings = {
      {exit_done, "done"},
      {exit_audit_violated, "a tolerance of the audit was violated"},
      {exit_usage, "wrong command line"},
      {exit_bad_input, "bad scene or input"},
      {exit_stopped, "the simulation could not continue"},
      {exit_file_error, "file or system error"},
      {exit_interrupted, "interrupted (files closed)"},
  };
  return meanings;
}

}  // namespace rigor
