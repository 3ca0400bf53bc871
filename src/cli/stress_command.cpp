#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "build_info.h"
#include "commands.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart_plot.h"
#include "raytracing/study/stress_page.h"
#include "raytracing/study/stress_plot.h"
#include "result_folder.h"
#include "signals.h"
#include "stress_options.h"

namespace raytracing {
namespace {

// Of pictures' names.
std::vector<std::string> with_extensions(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names)
    for (const char* extension : {".svg", ".png"}) files.push_back(name + extension);
  return files;
}

// The files drawn: none where gnuplot is missing.
std::vector<std::string> draw(const StressResult& result, const ResultFolder& folder) {
  if (!run_gnuplot(folder.path(), "stress.gp")) {
    fmt::print(stderr,
               "no heat maps drawn: gnuplot is missing (Debian: gnuplot-nox); gnuplot "
               "stress.gp in the folder draws them\n");
    return {};
  }
  const std::vector<std::string> drawn = with_extensions(stress_pictures(result));
  for (const std::string& name : drawn) folder.print_path(name);
  return drawn;
}

// Names the pictures that an earlier run left here, of other cases or with gnuplot at hand.
void tell_old_pictures(const std::vector<std::string>& drawn, const ResultFolder& folder) {
  std::vector<std::string> old;
  for (const std::string& name : with_extensions(all_stress_pictures()))
    if (std::find(drawn.begin(), drawn.end(), name) == drawn.end() &&
        std::filesystem::exists(folder.path() + "/" + name))
      old.push_back(name);
  if (!old.empty())
    fmt::print(stderr, "warning: {}: left by an earlier run: {}\n", one_line(folder.path()),
               fmt::join(old, ", "));
}

void write_results(const StressResult& result, const StressArguments& a, const ResultFolder& folder,
                   const std::string& command_line) {
  folder.write("stress.csv", stress_csv(result));
  folder.write("stress.dat", stress_plot_data(result));
  folder.write("stress.gp", stress_plot_script(result));
  const std::vector<std::string> drawn = draw(result, folder);
  folder.write("stress.html",
               report_html(stress_report(result, folder.path(), !drawn.empty(),
                                         {{"command", command_line},
                                          {"version", program_version()},
                                          {"build", build_description()},
                                          {"machine", machine_description()},
                                          {"seeds", std::to_string(a.plan.seeds)},
                                          {"line rays", std::to_string(a.plan.line_rays)}})));
  tell_old_pictures(drawn, folder);
}

void print_verdicts(const StressResult& result) {
  for (const std::string& line : stress_verdicts(result)) fmt::print(stderr, "{}\n", line);
  fmt::print(stderr, "{}\n", stress_rule(result.critical_z));
}

// One line for each cell that fails the run.
int exit_code(const StressResult& result) {
  for (const StressCell* c : result.failures())
    fmt::print(stderr,
               "FAILED: {} {}, {}: {}: bias {:+.3g} % ± {:.2g} %, z {:.1f}, {} samples "
               "not finite or below 0\n",
               c->stress_case->name, c->setting->label, c->method->name, to_string(c->verdict),
               100 * c->relative_bias(), 100 * c->relative(c->standard_error), c->z(),
               c->not_finite);
  return result.failures().empty() ? kExitGood : kExitCheckFailed;
}

}  // namespace

int stress_command(const Arguments& arguments) {
  const StressArguments a = parse_stress_arguments(arguments);
  if (a.text) {
    fmt::print("{}", *a.text);
    return kExitGood;
  }
  const StopOnSignal signals;  // before there are temporary files to leave behind
  const ResultFolder folder(a.folder, a.quiet);
  folder.create();
  {
    const OutputFile probe(folder.path() + "/stress.csv");  // before the work, not after it
  }
  ProgressDisplay display(a.quiet ? ProgressStyle::none : a.progress);
  const StressResult result =
      run_stress(a.plan, signals.stop(),
                 [&](std::uint64_t done, std::uint64_t total) { display.update(done, total); });
  display.finish(result.complete);
  if (!result.complete) {
    fmt::print(stderr, "stopped: nothing written\n");
    return kExitSignalBase + signals.signal();
  }
  write_results(result, a, folder, arguments.command_line);
  if (!a.quiet) print_verdicts(result);
  return exit_code(result);
}

}  // namespace raytracing
