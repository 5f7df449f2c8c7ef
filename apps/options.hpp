#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rigor {

// The options of the command line. An empty path means not requested; the JSON path "-" means stdout.

struct RunOptions {
  std::string scene;
  std::vector<std::string> outputs;
  std::vector<std::string> overrides;  ///< "key=value".
  std::optional<double> duration;      ///< [s].
  std::optional<double> cpu_limit;     ///< Processor time after which the run ends [s].
  int threads = 1;
  std::string json;
  bool is_quiet = false;
  bool keeps_path = false;  ///< Whether a trajectory may tell where the scene lies.
  bool separate = false;
  std::string checkpoint;
  std::optional<double> checkpoint_every;  ///< Simulated time [s].
  std::string resume;
};

struct CompareOptions {
  std::string scene;
  std::vector<std::string> variations;  ///< "key=a,b,c".
  std::vector<std::string> outputs;
  std::vector<std::string> overrides;   ///< "key=value".
  std::vector<std::string> references;  ///< "key=value" of the reference run; "none": no errors.
  std::optional<double> error_bound;    ///< [m].
  std::optional<double> cpu_limit;      ///< Limit of each run [s].
  std::optional<double> duration;       ///< [s].
  std::string json;
  bool is_quiet = false;
  bool separate = false;
};

struct CheckOptions {
  std::vector<std::string> scenes;
  bool has_estimate = false;  ///< Measure what a run would cost.
};

struct MassOptions {
  std::string file;
  std::optional<double> density;  ///< [kg/m³].
  int samples = 500000;           ///< Points per body.
  std::string json;
};

struct DistanceOptions {
  std::string scene, body_A, body_B;  ///< Empty for a body that is not given.
  std::optional<double> tolerance;    ///< Of the contact set [m].
  std::string ray;                    ///< Six numbers, "X,Y,Z DX,DY,DZ" [m], or empty.
  std::string point, push;            ///< "X,Y,Z" [m], or empty.
  std::optional<int> closest;         ///< Number of bodies.
  std::string json;
};

struct MethodsOptions {
  std::vector<std::string> words;  ///< What to look for, as one text; empty: everything is listed.
};

struct RenderOptions {
  std::string input;           ///< Scene or trajectory.
  std::string output;          ///< Empty: derived from the input.
  std::optional<double> time;  ///< [s].
  std::optional<int> frames;   ///< Number of pictures of a sequence or a film.
  bool is_sheet = false;
  std::string size;                     ///< "1280x720" [px], or empty.
  std::string eye, target;              ///< "x,y,z" [m], or empty.
  std::optional<double> field_of_view;  ///< [degrees].
  std::string mp4;
  std::vector<std::string> overrides;  ///< "key=value"; scenes only.
};

struct PlotOptions {
  std::string input;              ///< Trajectory, or runs of a study.
  std::vector<std::string> keys;  ///< Of a study they may be left out.
  std::string output;
};

struct ImpactOptions {
  std::string scene, body_A, body_B;   ///< Empty: K and u are given.
  std::string K, u;                    ///< Numbers separated by commas, or empty.
  std::string mu, e;                   ///< Texts of numbers; empty: those of the scene.
  std::string laws = "all";            ///< Names separated by commas.
  std::string stiffness_ratio;         ///< k_t/k_n; for the law `compliant` only.
  std::string tangential_restitution;  ///< For the law `chatterjee-ruina` only.
  std::optional<int> contact;          ///< Number of the contact point, from 1.
  std::optional<double> tolerance;     ///< Largest gap of touching bodies [m].
  std::vector<std::string> overrides;  ///< "key=value"; scenes only.
  std::string path, json, output;      ///< Table .csv; JSON; figure .svg or .png.
};

struct ConvertOptions {
  std::string input;   ///< Mesh.
  std::string output;  ///< Pieces as a scene (.yaml) or mesh (.obj).
  bool is_mesh_output = false;
  bool is_exact = false;
  int max_pieces = 64;
  std::optional<double> tolerance;  ///< Largest distance of points of a piece from the solid [m].
  std::string json;
};

struct ViewOptions {
  std::string file;                    ///< Scene or trajectory (.h5).
  std::vector<std::string> overrides;  ///< "key=value".
  std::uint16_t port = 0;              ///< 0: a free one.
  bool opens_browser = false;
};

struct StudyOptions {
  std::string file;
  std::vector<std::string> outputs;
  int threads = 0;      ///< 0: as many as the machine has; under MPI 1 a process.
  std::string journal;  ///< Empty: the name of the study file with .journal, in this folder.
  bool has_journal = true;
  bool is_dry = false;               ///< Only foresee the cost.
  std::optional<std::uint64_t> run;  ///< Instead: one run once more, as `rigor run` does.
  bool keeps_runs = false;           ///< A page for each run, beside that of the study.
  bool is_viewed = false;            ///< Serve the page of the study at its end.
  std::uint16_t port = 0;            ///< 0: a free one.
  bool opens_browser = false;
  std::string json;
  bool is_quiet = false;
};

using Command =
    std::variant<RunOptions, ViewOptions, CompareOptions, CheckOptions, MassOptions, DistanceOptions,
                 MethodsOptions, RenderOptions, PlotOptions, ImpactOptions, ConvertOptions, StudyOptions>;

}  // namespace rigor
