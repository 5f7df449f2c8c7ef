#include "apps/command_line.hpp"

#include "apps/command_pages.hpp"
#include "apps/impact_laws.hpp"
#include "apps/option_checks.hpp"
#include "apps/terminal.hpp"
#include "apps/usage_error.hpp"
#include "rigor/core/quoted.hpp"
#include "rigor/core/range.hpp"
#include "rigor/core/suggestion.hpp"
#include "rigor/io/files/version.hpp"
#include "rigor/io/trajectory/trajectory_writer.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <memory>

namespace rigor {

namespace {

constexpr Range time_span{0, 1e9, true};  // [s]
constexpr Range length{0, 1e9};           // [m]
constexpr Range density{0, 1e12, true};   // [kg/m³]
constexpr Range view_angle{1, 170};       // [degrees]
constexpr int most_threads = 1024;
constexpr int most_frames = 100000;
constexpr int highest_port = 65535;
constexpr int most_contacts = 1000000;
constexpr int most_pieces = 100000;
constexpr int fewest_samples = 2, most_samples = 1000000000;

/// Checks the text of a number: it must be decimal and inside the range.
CLI::Validator number_in(const Range& range, const std::string& unit) {
  return CLI::Validator(
      [range, unit](const std::string& text) -> std::string {
        double value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size())
          return quoted_text(text) + " is not a number";
        return range_error("the value", value, range, unit);
      },
      "");
}

/// Adds an option whose value is the next argument, and never more than one.
template <typename Value>
CLI::Option* add_value(CLI::App& app, const std::string& name, Value& value, const std::string& what,
                       const std::string& placeholder) {
  return app.add_option(name, value, what)->option_text(placeholder)->allow_extra_args(false);
}

void add_json(CLI::App& app, std::string& json, const std::string& what) {
  add_value(app, "--json", json, what + " as JSON to a file, or to stdout with -", "FILE|-");
}

void add_run(CLI::App& app, RunOptions& run) {
  app.add_option("SCENE", run.scene, "scene file (.yaml or .json)")->required()->option_text(" ");
  add_value(app, "-o,--output", run.outputs,
            "by suffix: trajectory " + trajectory_suffixes() +
                ", page with the replay .html, key moments .png, film .mp4 (by ffmpeg); may be repeated",
            "OUT");
  add_value(app, "--set", run.overrides,
            "override a value of the scene, such as method.integrator=rk4; may be repeated", "KEY=VALUE");
  add_value(app, "--duration", run.duration, "simulated time at which the run ends [s]", "S")
      ->check(number_in(time_span, "s"));
  add_value(app, "--cpu-limit", run.cpu_limit,
            "processor time after which the run is ended, with what there is by then [s]", "S")
      ->check(number_in(time_span, "s"));
  add_value(
      app, "--threads", run.threads,
      "threads on which steps (time-stepping, also under auto) and, by the schemes of events, groups of "
      "bodies far from each other are computed; the answer does not depend on it",
      "N")
      ->check(CLI::Range(1, most_threads));
  add_json(app, run.json, "the audit");
  app.add_flag("--quiet", run.is_quiet, "print no audit and no progress");
  app.add_flag("--separate", run.separate, "push apart bodies that overlap at t = 0");
  app.add_flag("--keep-path", run.keeps_path,
               "store the scene's full path in .h5, so that its mesh files are found from elsewhere");
  add_value(app, "--checkpoint", run.checkpoint,
            "keep a file to resume from: written at the end or when interrupted", "FILE");
  add_value(app, "--checkpoint-every", run.checkpoint_every, "write it also after each S s of simulated time",
            "S")
      ->check(number_in(time_span, "s"));
  add_value(app, "--resume", run.resume, "continue from a checkpoint of the same scene, bit for bit", "FILE");
}

void add_compare(CLI::App& app, CompareOptions& compare) {
  app.add_option("SCENE", compare.scene, "scene file (.yaml or .json)")->required()->option_text(" ");
  add_value(app, "--vary", compare.variations,
            "a key of the scene and its values in turn, such as "
            "method.scheme=event-driven,hybrid or run.step=0.01,0.005; repeated: all combinations, 64 runs "
            "at most",
            "KEY=a,b,c")
      ->required();
  add_value(
      app, "-o,--output", compare.outputs,
      "by suffix: page .html (motion of the first 8 runs), plot of the energies .svg .png (8 runs at most), "
      "table .json .csv; may be "
      "repeated",
      "OUT");
  add_value(app, "--set", compare.overrides, "override a value of the scene in all runs; may be repeated",
            "KEY=VALUE");
  add_value(
      app, "--reference", compare.references,
      "a value of the run that errors are measured against, such as method.integrator=dop853; repeated: "
      "several values; none: no errors. Default: what the scene expects, else a converged event-driven "
      "run",
      "KEY=VALUE");
  add_value(app, "--bound", compare.error_bound,
            "error up to which a motion is good [m]; default: 1 % of the largest radius of a moving body",
            "M")
      ->check(number_in(length, "m"));
  add_value(app, "--cpu-limit", compare.cpu_limit, "processor time after which a run is ended [s]", "S")
      ->check(number_in(time_span, "s"));
  add_value(app, "--duration", compare.duration, "simulated time at which the runs end [s]", "S")
      ->check(number_in(time_span, "s"));
  add_json(app, compare.json, "the table with all audits");
  app.add_flag("--quiet", compare.is_quiet, "print no table and no progress");
  app.add_flag("--separate", compare.separate, "push apart bodies that overlap at t = 0");
}

void add_view(CLI::App& app, ViewOptions& view) {
  app.add_option("SCENE|TRAJECTORY", view.file, "scene (live) or trajectory (.h5, replay)")
      ->required()
      ->option_text(" ");
  add_value(app, "--set", view.overrides, "override a value of the scene; may be repeated", "KEY=VALUE");
  add_value(app, "--port", view.port, "port on 127.0.0.1; default: a free one", "P")
      ->check(CLI::Range(1, highest_port));
  app.add_flag("--open", view.opens_browser, "open the page in the browser");
}

void add_mass(CLI::App& app, MassOptions& mass) {
  app.add_option("MESH|SCENE", mass.file, "mesh (.obj .stl .ply) or scene")->required()->option_text(" ");
  add_value(app, "--density", mass.density, "[kg/m^3]; default 1000 for a mesh, the materials' for a scene",
            "D")
      ->check(number_in(density, "kg/m³"));
  add_value(app, "--samples", mass.samples, "points per body of the sampled estimate", "N")
      ->check(CLI::Range(fewest_samples, most_samples));
  add_json(app, mass.json, "the result");
}

void add_distance(CLI::App& app, DistanceOptions& distance) {
  app.add_option("SCENE", distance.scene, "scene file")->required()->option_text(" ");
  app.add_option("BODY_A", distance.body_A, "name of a body")->option_text(" ");
  app.add_option("BODY_B", distance.body_B, "name of another")->option_text(" ");
  add_value(app, "--tolerance", distance.tolerance,
            "of the contact set [m]; default: the scene's contact_tolerance", "D")
      ->check(number_in(length, "m"));
  add_value(app, "--ray", distance.ray, "instead: the bodies that a ray hits, its origin and direction [m]",
            "\"X,Y,Z DX,DY,DZ\"");
  add_value(app, "--point", distance.point, "instead: the body closest to a point [m]", "X,Y,Z");
  add_value(app, "--closest", distance.closest, "instead: the K bodies closest to BODY_A, or to --point", "K")
      ->check(CLI::Range(1, most_contacts));
  add_value(app, "--push", distance.push,
            "instead: the first body that BODY_A hits when it is moved by this displacement [m]", "X,Y,Z");
  add_json(app, distance.json, "the result");
}

void add_render(CLI::App& app, RenderOptions& render) {
  app.add_option("SCENE|RUN.h5", render.input, "scene, which is simulated first, or trajectory")
      ->required()
      ->option_text(" ");
  add_value(app, "-o,--output", render.output, "picture .png, or film .mp4; default: named after the input",
            "OUT");
  add_value(app, "--time", render.time, "one picture, of the output time nearest to T [s]", "T");
  add_value(app, "--frames", render.frames, "N pictures from start to end: OUT_0001.png, ...", "N")
      ->check(CLI::Range(1, most_frames));
  app.add_flag("--sheet", render.is_sheet, "the key moments side by side (default)");
  add_value(app, "--size", render.size, "of each picture [px]", "WxH");
  add_value(app, "--eye", render.eye, "position of the camera [m]; default: derived from the motion",
            "X,Y,Z");
  add_value(app, "--target", render.target, "point in the middle of the picture [m]", "X,Y,Z");
  add_value(app, "--field-of-view", render.field_of_view, "from the upper to the lower edge [degrees]", "A")
      ->check(number_in(view_angle, "degrees"));
  add_value(app, "--mp4", render.mp4, "film of the whole run, encoded by the program ffmpeg", "OUT.mp4");
  add_value(app, "--set", render.overrides, "override a value of the scene; may be repeated", "KEY=VALUE");
}

void add_plot(CLI::App& app, PlotOptions& plot) {
  app.add_option("RUN.h5", plot.input, "trajectory, or runs of a study")->required()->option_text(" ");
  app.add_option(
         "KEYS", plot.keys,
         "energy.kinetic|potential|elastic|total, momentum[.x|y|z], penetration, "
         "body.NAME.position|velocity|angular_velocity[.x|y|z], body.NAME.orientation.w|x|y|z, "
         "JOINT.coordinate|rate, JOINT.force|torque[.x|y|z]; of a study: NAME (histogram), Y:X, matrix, "
         "parallel")
      ->option_text("...");
  add_value(app, "-o,--output", plot.output, "plot, by suffix: .svg .png", "OUT")->required();
}

void add_impact(CLI::App& app, ImpactOptions& impact) {
  app.add_option("SCENE", impact.scene, "scene file; or give --K and --u")->option_text(" ");
  app.add_option("BODY_A", impact.body_A, "name of a body")->option_text(" ");
  app.add_option("BODY_B", impact.body_B, "name of another, which touches it at t = 0")->option_text(" ");
  add_value(app, "--K", impact.K, "collision matrix [1/kg]: K11,K12,K13,K22,K23,K33 or all nine numbers",
            "K");
  add_value(app, "--u", impact.u, "velocity of B against A [m/s]: two tangential numbers and the normal one",
            "X,Y,Z");
  add_value(app, "--mu", impact.mu, "Coulomb friction; default: the pair's in the scene", "MU|inf");
  add_value(app, "--e", impact.e, "restitution, from 0 to 1; default: the pair's in the scene", "E");
  add_value(app, "--law", impact.laws,
            fmt::format("{}, several with commas; all (default): the first {}", law_names(),
                        restitution_rules().size()),
            "LAW");
  add_value(app, "--stiffness-ratio", impact.stiffness_ratio,
            "tangential over normal stiffness of the contact, for compliant", "R");
  add_value(app, "--et", impact.tangential_restitution,
            "tangential restitution, from -1 to 1, for chatterjee-ruina", "ET");
  add_value(app, "--contact", impact.contact, "which contact point of the two bodies, from 1", "N")
      ->check(CLI::Range(1, most_contacts));
  add_value(app, "--tolerance", impact.tolerance,
            "largest gap of touching bodies [m]; default: the scene's contact_tolerance", "D")
      ->check(number_in(length, "m"));
  add_value(app, "--set", impact.overrides, "override a value of the scene; may be repeated", "KEY=VALUE");
  add_value(app, "--path", impact.path, "table of the impact path", "FILE.csv");
  add_json(app, impact.json, "the result");
  add_value(app, "-o,--output", impact.output, "figure of the paths and the energy lost, .svg or .png",
            "OUT");
}

void add_convert(CLI::App& app, ConvertOptions& convert) {
  app.add_option("IN", convert.input, "mesh (.obj .stl .ply), closed for pieces")
      ->required()
      ->option_text(" ");
  app.add_option("OUT", convert.output, "by suffix: convex pieces as a scene .yaml, or mesh .obj")
      ->required()
      ->option_text(" ");
  app.add_flag("--exact", convert.is_exact, "pieces that are the solid, up to rounding, or none");
  add_value(app, "--max-pieces", convert.max_pieces, "most pieces; default 64", "N")
      ->check(CLI::Range(1, most_pieces));
  add_value(app, "--tolerance", convert.tolerance,
            "how far a piece may protrude from the solid [m]; default: 1 % of its size", "M")
      ->check(number_in(length, "m"));
  add_json(app, convert.json, "the result");
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* const option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* const command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

/// Refuses arguments that neither the program nor the chosen command knows; options first, because the rest
/// may follow from them.
void check_unknown(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::vector<std::string> unknown = command.remaining();
  for (const std::string& argument : unknown) {
    if (argument.size() < 2 || argument[0] != '-') continue;
    const std::string name = argument.substr(0, argument.find('='));
    const std::vector<std::string> names = option_names(command);
    throw UsageError("unknown option " + quoted_text(name) + suggestion(name, names));
  }
  if (unknown.empty()) return;
  if (chosen.empty()) {
    throw UsageError("unknown command " + quoted_text(unknown[0]) +
                     suggestion(unknown[0], command_names(app)));
  }
  throw UsageError("unexpected argument " + quoted_text(unknown[0]) + "; see 'rigor " + command.get_name() +
                   " --help'");
}

/// The options as the command that they form.
template <typename Options>
Command checked(const Options& options) {
  return options;
}
Command checked(const RunOptions& run) {
  check_run(run);
  return run;
}
Command checked(const CompareOptions& compare) {
  check_compare(compare);
  return compare;
}

Command checked(const StudyOptions& study) {
  check_study(study);
  return study;
}

Command checked(ConvertOptions convert) {
  check_convert(convert);
  return convert;
}

void add_study(CLI::App& app, StudyOptions& study) {
  constexpr std::uint64_t most_run_number = 1000000000000;
  app.add_option("FILE", study.file, "study file, or scene with a study in it (.yaml)")
      ->required()
      ->option_text(" ");
  add_value(app, "-o,--output", study.outputs,
            "by suffix: runs .csv .h5, answer .json, page .html, figures .svg .png; may be repeated", "OUT");
  add_value(app, "--threads", study.threads,
            "threads on which runs are carried out; default: all of the machine, under mpirun one a process",
            "N")
      ->check(CLI::Range(1, most_threads));
  add_value(app, "--journal", study.journal,
            "keep the runs in this file, and go on from it; default: the study's name with .journal, here",
            "FILE");
  app.add_flag("!--no-journal", study.has_journal, "keep no journal; an interrupted study begins anew");
  app.add_flag("--dry-run", study.is_dry, "carry out the first run only, and say what the study will cost");
  add_value(app, "--run", study.run,
            "instead: run N once more, as `rigor run` does; -o takes what it takes: .html .h5 .csv ...", "N")
      ->check(CLI::Range(std::uint64_t{0}, most_run_number));
  app.add_flag("--keep", study.keeps_runs,
               "with -o PAGE.html: a page for each run in PAGE_runs/, to which it leads");
  app.add_flag("--view", study.is_viewed,
               "at the end serve the page of the study on this machine; a click on a run replays it");
  add_value(app, "--port", study.port, "of --view, on 127.0.0.1; default: a free one", "P")
      ->check(CLI::Range(1, highest_port));
  app.add_flag("--open", study.opens_browser, "open the page of --view in the browser");
  add_json(app, study.json, "the answer");
  app.add_flag("--quiet", study.is_quiet, "print no answer and no progress");
}

void add_check(CLI::App& app, CheckOptions& check) {
  app.add_option("SCENE", check.scenes, "scene files")->required()->option_text("...");
  app.add_flag(
      "--estimate", check.has_estimate,
      "measure also what the run would cost, as written and with each other scheme; some twenty seconds");
}

void add_methods(CLI::App& app, MethodsOptions& methods) {
  app.add_option("WORD", methods.words, "a choice, an author, or a word of the courses: contact region")
      ->option_text("...");
}

/// Adds a command whose options are kept in `chosen` when it is the one that is requested.
template <typename Options>
void add_command(CLI::App& app, const std::string& name, const std::string& what,
                 void (*add_options)(CLI::App&, Options&), std::optional<Command>& chosen) {
  CLI::App& command = *app.add_subcommand(name, what);
  const std::shared_ptr<Options> options = std::make_shared<Options>();
  add_options(command, *options);
  // Unknown arguments are reported here, with the nearest name, and before errors in the rest.
  command.allow_extras();
  command.final_callback([&app, &chosen, options] {
    check_unknown(app);
    chosen = checked(*options);
  });
}

void add_commands(CLI::App& app, std::optional<Command>& chosen) {
  add_command(app, "run", "simulate a scene and print the audit", add_run, chosen);
  add_command(app, "view", "show a scene live, or a trajectory, in the browser, on this machine only",
              add_view, chosen);
  add_command(app, "compare", "the same scene with several methods or values: errors, energy, CPU time",
              add_compare, chosen);
  add_command(app, "study",
              "thousands of runs for an answer: sweeps, shares, thresholds, sensitivity, optima", add_study,
              chosen);
  add_command(app, "check", "validate scenes without running them", add_check, chosen);
  add_command(app, "mass", "mass properties of a mesh or a scene, exact and sampled", add_mass, chosen);
  add_command(app, "distance", "signed distance and contacts of two bodies at t = 0; rays, points, pushes",
              add_distance, chosen);
  add_command(app, "convert", "a solid as convex pieces for a scene, or a mesh as .obj", add_convert, chosen);
  add_command(app, "methods", "list every method, with its source, or find a word of the courses",
              add_methods, chosen);
  add_command(app, "render", "pictures and films of a scene or a trajectory", add_render, chosen);
  add_command(app, "plot", "plot quantities of a trajectory over time, or the runs of a study", add_plot,
              chosen);
  add_command(app, "impact", "one frictional impact in detail, under several laws", add_impact, chosen);
}

/// The option as help and manuals show it; placeholders of arguments are their names.
OptionPage page_of(const CLI::Option& option) {
  OptionPage page{.what = option.get_description(), .is_required = option.get_required()};
  const std::string& text = option.get_option_text();
  if (option.get_positional()) {
    page.placeholder = option.get_name(true);
    page.is_list = text == "...";
    return page;
  }
  for (const std::string& name : option.get_snames()) page.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) page.names.push_back("--" + name);
  page.placeholder = text;
  return page;
}

CommandPage page_of(const CLI::App& command) {
  CommandPage page{command.get_name(), command.get_description(), {}, {}};
  for (const CLI::Option* const option : command.get_options())
    (option->get_positional() ? page.arguments : page.options).push_back(page_of(*option));
  return page;
}

ProgramPages pages_of(const CLI::App& app) {
  ProgramPages pages{app.get_description(), std::string(version), {}, {}};
  for (const CLI::Option* const option : app.get_options()) pages.options.push_back(page_of(*option));
  for (const CLI::App* const command : app.get_subcommands({})) pages.commands.push_back(page_of(*command));
  return pages;
}

const CommandPage& find_page(const ProgramPages& pages, const std::string& name) {
  const auto found = std::ranges::find(pages.commands, name, &CommandPage::name);
  if (found != pages.commands.end()) return *found;
  std::vector<std::string> names;
  for (const CommandPage& page : pages.commands) names.push_back(page.name);
  throw UsageError("unknown command " + quoted_text(name) + suggestion(name, names));
}

/// Help of the program, or of the command of that name; as wide as the terminal, up to what reads well.
std::string help_of(const CLI::App& app, const std::string& name) {
  constexpr int narrowest = 40, widest = 100;
  const int width = is_terminal(stdout) ? std::clamp(terminal_width(stdout), narrowest, widest) : widest;
  const ProgramPages pages = pages_of(app);
  return name.empty() ? help_text(pages, width) : help_text(find_page(pages, name), width);
}

std::string manual_of(const CLI::App& app, const std::string& name) {
  const ProgramPages pages = pages_of(app);
  return name.empty() ? manual_text(pages) : manual_text(pages, find_page(pages, name));
}

std::string completion_of(const CLI::App& app, const std::string& shell) {
  std::string script = completion_text(pages_of(app), shell);
  if (script.empty())
    throw UsageError("unknown shell " + quoted_text(shell) + suggestion(shell, completion_shells()));
  return script;
}

/// Adds a command that only prints something about the program: a text of its own definitions and one word.
void add_text_command(CLI::App& app, const std::string& name, const std::string& what,
                      const std::string& word, std::string (*text)(const CLI::App&, const std::string&),
                      std::string& message) {
  CLI::App& command = *app.add_subcommand(name, what);
  const std::shared_ptr<std::string> given = std::make_shared<std::string>();
  command
      .add_option(word, *given,
                  word == "SHELL" ? "bash, zsh or fish" : "name of a command; default: the program")
      ->required(word == "SHELL")
      ->option_text(" ");
  command.allow_extras();
  command.final_callback([&app, &message, given, text] {
    check_unknown(app);
    message = text(app, *given);
  });
}

void add_text_commands(CLI::App& app, std::string& message) {
  add_text_command(app, "help", "all about one command", "COMMAND", help_of, message);
  add_text_command(app, "completion", "the script by which a shell completes commands and options", "SHELL",
                   completion_of, message);
  add_text_command(app, "manual", "the man page of the program or of a command", "COMMAND", manual_of,
                   message);
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, const char* const* argv) {
  CLI::App app("Rigid-body dynamics whose answers can be trusted.", "rigor");
  app.set_help_flag("-h,--help", "print this help");
  app.set_version_flag("-v,--version", "rigor " + std::string(version), "print the version");
  app.require_subcommand(0, 1);
  app.allow_extras();
  std::optional<Command> chosen;
  std::string message;
  add_commands(app, chosen);
  add_text_commands(app, message);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const std::vector<CLI::App*> asked = app.get_subcommands();
    message = help_of(app, asked.empty() ? "" : asked.front()->get_name());
  } catch (const CLI::Success& version_wanted) {
    app.exit(version_wanted);
    return {};
  } catch (const CLI::ParseError& error) {
    check_unknown(app);
    throw UsageError(error.what());
  }
  if (!message.empty()) {
    fmt::print("{}", message);
    return {};
  }
  if (chosen) return {chosen};
  check_unknown(app);
  fmt::print(stderr, "{}", help_of(app, ""));
  return {std::nullopt, exit_usage};
}

}  // namespace rigor
