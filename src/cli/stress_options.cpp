#include "stress_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "limits.h"
#include "method_list.h"
#include "option_list.h"

namespace raytracing {
namespace {

constexpr std::uint64_t kMaxSeeds = 1 << 16;

// Fills `a`; names of cases gather in `names`.
struct StressOptionList : OptionList {
  StressArguments& a;
  std::vector<std::string> names;

  explicit StressOptionList(StressArguments& arguments)
      : OptionList(
            "Looks for where the methods fail: sweeps of one parameter towards trouble, "
            "each measured against the exact radiance of one point. Fails (exit code 1) "
            "when a method that claims to be unbiased is not, or a sample is not finite.",
            "Raytracing stress"),
        a(arguments) {
    add_text("--out", a.folder, "DIR", "Folder for stress.csv, the heat maps and stress.html");
    add_texts("--case", names, "NAME",
              "Only this case; may be given several times; default all, see below");
    add_parsed(
        "--methods", "A,B,...",
        [this](const std::string& text) { a.plan.methods = parse_methods(text); },
        "Light sampling methods, of " + alternatives(direct_method_names()) + "; default all");
    add_number("--seeds", a.plan.seeds, 1, kMaxSeeds,
               fmt::format("Of each cell; {} pixels of {} samples a seed; default {}",
                           kPixelsPerSeed, kStressSpp, a.plan.seeds));
    add_number(
        "--line-rays", a.plan.line_rays, 1, kMaxLineRays,
        fmt::format("Rays per chord of the methods that count rays; default {}", a.plan.line_rays));
    add_number("--threads", a.plan.threads, 1, kMaxThreads,
               "Threads; default: as many as the machine has");
    add_choice(
        "--progress", {"auto", "bar", "jsonl", "none"},
        [this](const std::string& name) { a.progress = *progress_style(name); },
        "How progress is shown on stderr: auto (default; a bar on a terminal, else "
        "nothing), bar, jsonl (one JSON object per line) or none");
    add_switch("--quiet", a.quiet, "Print nothing but errors, warnings and failures");
    add_cases();
  }

  // Those named, in the order of the table.
  std::vector<const StressCase*> chosen_cases() const {
    for (const std::string& name : names) check_name("--case", name, stress_case_names());
    std::vector<const StressCase*> cases;
    for (const StressCase& c : stress_cases())
      if (names.empty() || std::find(names.begin(), names.end(), c.name) != names.end())
        cases.push_back(&c);
    return cases;
  }

 private:
  void add_cases() {
    std::string text = "Cases, each with what it sweeps:\n";
    for (const StressCase& c : stress_cases())
      text += fmt::format("  {:<16}{}: {} .. {}\n", c.name, c.parameter, c.settings.front().label,
                          c.settings.back().label);
    add_footer(text);
  }
};

}  // namespace

StressArguments parse_stress_arguments(const Arguments& arguments) {
  StressArguments a;
  a.plan.methods = all_methods();
  a.plan.threads = default_threads();
  StressOptionList options(a);
  a.text = options.parse(arguments);
  if (a.text) return a;
  a.plan.cases = options.chosen_cases();
  if (a.folder.empty()) throw_usage("--out: no folder given");
  return a;
}

}  // namespace raytracing
