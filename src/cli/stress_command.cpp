#include <fmt/format.h>

#include <cstdio>

#include "build_info.h"
#include "commands.h"
#include "raytracing/cli/app.h"
#include "raytracing/io/file.h"
#include "raytracing/study/chart_plot.h"
#include "raytracing/study/stress_page.h"
#include "raytracing/study/stress_plot.h"
#include "result_folder.h"
#include "signals.h"
#include "stress_options.h"

namespace raytracing {
namespace {

bool draw(const StressResult& result, const ResultFolder& folder) {
  if (!run_gnuplot(folder.path(), "stress.gp")) {
    fmt::print(stderr, "no heat maps drawn: gnuplot is missing (Debian: gnuplot-nox); gnuplot "
                       "stress.gp in the folder draws them\n");
    return false;
  }
  for (const std::string& name : stress_pictures(result))
    for (const char* extension : {".svg", ".png"}) folder.print_path(name + extension);
  return true;
}

void write_results(const StressResult& result, const StressArguments& a, const ResultFolder& folder,
                   const std::string& command_line) {
  folder.write("stress.csv", stress_csv(result));
  folder.write("stress.dat", stress_plot_data(result));
  folder.write("stress.gp", stress_plot_script(result));
  const bool has_pictures = draw(result, folder);
  folder.write("stress.html",
               report_html(stress_report(result, folder.path(), has_pictures,
                                         {{"command", command_line},
                                          {"version", program_version()},
                                          {"build", build_description()},
                                          {"machine", machine_description()},
                                          {"seeds", std::to_string(a.plan.seeds)},
                                          {"line rays", std::to_string(a.plan.line_rays)}})));
}

void print_verdicts(const StressResult& result) {
  for (const std::string& line : stress_verdicts(result)) fmt::print(stderr, "{}\n", line);
  fmt::print(stderr, "{}\n", stress_rule(result.critical_z));
}

// One line for each cell that fails the run.
int exit_code(const StressResult& result) {
  for (const StressCell* c : result.failures())
    fmt::print(stderr, "FAILED: {} {}, {}: {}: bias {:+.3g} % ± {:.2g} %, z {:.1f}, {} samples "
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
