#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "app.h"
#include "build_info.h"
#include "common_options.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/study/page/result_folder.h"
#include "raytracing/study/stress/report.h"
#include "raytracing/study/stress/run.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kMaxSeeds = 1 << 16;

struct StressArguments : RunArguments {
  StressPlan plan;
  std::string folder;
};

std::string cases_text() {
  std::string text = "Cases, with the parameter that each one varies and its range:\n";
  for (const StressCase& c : stress_cases()) {
    const std::string sweep =
        fmt::format("{}: {} .. {}", c.parameter, c.settings.front().label, c.settings.back().label);
    text += fmt::format("  {:<16}{}\n", c.name, wrapped(sweep, 80, 18));
  }
  return text;
}

StressArguments parse_stress_arguments(const Arguments& arguments) {
  StressArguments a;
  std::vector<std::string> names;
  OptionList options(
      "Looks for failures of the direct-light methods: each case varies one parameter towards a "
      "difficult limit and compares the radiance at one point with its exact value. Ends with exit "
      "code 1 if a method that is documented as unbiased is found biased, or a sample is not "
      "finite.",
      "Raytracing stress");
  options.value("--out", a.folder, "DIR", "Folder for stress.csv, the heat maps and stress.html.");
  options.group("Measurement");
  options
      .values("--case", names, "NAME",
              "Measure only this case. May be repeated. Default: all cases, which are listed "
              "below.")
      ->check(one_of(stress_case_names()));
  add_methods_option(options, a.plan.methods);
  options.number("--seeds", a.plan.seeds, 1, kMaxSeeds,
                 fmt::format("Number of seeds for each measurement; each one adds {} pixels of {} "
                             "samples.",
                             kPixelsPerSeed, kStressSpp));
  add_line_rays_option(options, a);
  options.group("Execution");
  add_run_options(options, a);
  options.footer("\n" + cases_text());
  options.parse(arguments.values);
  for (const StressCase& c : stress_cases())  // in the order of the table
    if (names.empty() || std::find(names.begin(), names.end(), c.name) != names.end())
      a.plan.cases.push_back(&c);
  a.plan.line_rays = a.line_rays;
  a.plan.threads = a.threads;
  if (a.folder.empty()) throw_usage("--out: no folder given");
  return a;
}

// Draws the heat maps and returns their files; none if gnuplot is missing.
std::vector<std::string> draw(const StressResult& result, const ResultFolder& folder) {
  std::vector<std::string> files = picture_files(stress_pictures(result));
  if (folder.draw("stress.gp", files)) return files;
  print_message(
      "warning: no heat maps drawn: gnuplot is missing (Debian: gnuplot-nox); with it, run gnuplot "
      "stress.gp in the folder\n");
  return {};
}

// Names the heat maps that an earlier run left in the folder, from other cases or with gnuplot.
void warn_of_old_plots(const std::vector<std::string>& drawn, const ResultFolder& folder) {
  std::vector<std::string> old;
  for (const std::string& name : picture_files(all_stress_pictures()))
    if (std::find(drawn.begin(), drawn.end(), name) == drawn.end() &&
        std::filesystem::exists(folder.path() + "/" + name))
      old.push_back(name);
  if (!old.empty())
    print_message("warning: {}: left by an earlier run: {}\n", one_line(folder.path()),
                  fmt::join(old, ", "));
}

void write_results(const StressResult& result, const StressPlan& plan, const ResultFolder& folder,
                   const std::string& command_line) {
  folder.write("stress.csv", stress_csv(result));
  folder.write("stress.dat", stress_plot_data(result));
  folder.write("stress.gp", stress_plot_script(result));
  const std::vector<std::string> drawn = draw(result, folder);
  RunFacts facts = program_facts();
  facts.command = command_line;
  facts.line_rays = plan.line_rays;
  auto rows = fact_rows(facts);
  rows.emplace_back("number of seeds", std::to_string(plan.seeds));
  folder.write("stress.html",
               report_html(stress_report(result, folder.path(), !drawn.empty(), std::move(rows))));
  warn_of_old_plots(drawn, folder);
}

void print_verdicts(const StressResult& result) {
  for (const std::string& line : stress_verdicts(result)) print_message("{}\n", line);
  print_message("{}\n", stress_rule(result.critical_z));
}

// Prints a line for each measurement that fails the run.
int exit_code(const StressResult& result) {
  for (const StressCell* c : result.failures())
    print_message(
        "FAILED: {} {}, {}: {}: bias {:+.3g} % ± {:.2g} %, z {:.1f}; {} samples not finite "
        "or negative\n",
        c->stress_case->name, c->setting->label, c->method->name, to_string(c->verdict),
        100 * c->relative_bias(), 100 * c->relative(c->standard_error), c->z(), c->not_finite);
  return result.failures().empty() ? kExitGood : kExitCheckFailed;
}

}  // namespace

int stress_command(const Arguments& arguments) {
  const StressArguments a = parse_stress_arguments(arguments);
  const StopOnSignal signals;  // before there are temporary files to leave behind
  const ResultFolder folder(a.folder, [&a](const std::string& name) {
    if (!a.quiet) fmt::print("{}/{}\n", a.folder, name);
  });
  { const OutputFile probe(a.folder + "/stress.csv"); }  // found unwritable before the work
  ProgressDisplay display(a.shown_progress());
  const StressResult result =
      run_stress(a.plan, signals.stop(),
                 [&](std::uint64_t done, std::uint64_t total) { display.update(done, total); });
  display.finish(result.complete);
  if (!result.complete) {
    print_message("stopped: nothing written\n");
    return kExitSignalBase + signals.signal();
  }
  write_results(result, a.plan, folder, arguments.command_line);
  if (!a.quiet) print_verdicts(result);
  return exit_code(result);
}

}  // namespace raytracing
