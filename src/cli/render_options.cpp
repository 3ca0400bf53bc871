#include "render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <thread>
#include <type_traits>

#include "build_info.h"
#include "option_values.h"
#include "raytracing/io/errors.h"
#include "raytracing/io/image_file.h"
#include "raytracing/io/nearest_name.h"

namespace raytracing {
namespace {

constexpr int kMaxImageSize = 65536;
constexpr std::uint64_t kMaxSpp = std::uint64_t{1} << 40;
constexpr int kMaxThreads = 1024;
constexpr int kMaxLineRays = 65536;
constexpr std::uint64_t kMaxDepth = std::uint64_t{1} << 30;
constexpr std::size_t kHelpWidth = 68;  // of the descriptions: CLI11 starts them at column 30

// The number behind an optional one.
template <class Field>
struct NumberOf : std::type_identity<Field> {};
template <class Number>
struct NumberOf<std::optional<Number>> : std::type_identity<Number> {};

std::string methods_text() {
  std::string text;
  for (const DirectMethod& m : direct_methods())
    text += fmt::format("{:<12} {}: {}; costs {}\n", m.name, m.unbiased ? "unbiased" : "BIASED",
                        m.summary, m.cost);
  return text;
}

int default_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

RenderArguments::Replay parse_replay(const std::string& text) {
  const std::size_t first = text.find(','), last = text.rfind(',');
  if (first == last) throw UsageError("--replay: '" + text + "' is not X,Y,SAMPLE");
  const auto number = [&](std::size_t from, std::size_t to, std::uint64_t high) {
    return whole_number("--replay", std::string_view(text).substr(from, to - from), 0, high);
  };
  return {static_cast<int>(number(0, first, kMaxImageSize - 1)),
          static_cast<int>(number(first + 1, last, kMaxImageSize - 1)),
          number(last + 1, text.size(), kMaxSpp - 1)};
}

// The one list of options: parsing and help both come from it.
struct OptionList {
  CLI::App app{"Renders a scene to pictures. The word render may be left out.",
               "Raytracing [render]"};
  RenderArguments& a;
  bool list_methods = false;
  bool version = false;

  explicit OptionList(RenderArguments& arguments) : a(arguments) {
    app.set_help_flag("-h,--help", "This text");
    add_text("--scene,scene", a.scene, "FILE.toml", "Scene file (TOML)");
    add_picture_options();
    add_sampling_options();
    add_report_options();
  }

  CLI::Option* add_text(const std::string& name, std::string& value, const char* type,
                        const std::string& description) {
    return app.add_option(name, value, wrapped(description, kHelpWidth))->type_name(type);
  }

  // Not CLI11's numbers: it reads 010 as 8, -1 as 2^64 - 1 and what is too large as the largest.
  template <class Field>
  void add_number(const std::string& name, Field& value, std::uint64_t low, std::uint64_t high,
                  const std::string& description) {
    const auto set = [&value, name, low, high](const std::string& text) {
      value = static_cast<typename NumberOf<Field>::type>(whole_number(name, text, low, high));
    };
    app.add_option_function<std::string>(name, set, wrapped(description, kHelpWidth))
        ->type_name("N");
  }

  void add_choice(const std::string& name, const std::vector<std::string>& names,
                  const std::function<void(const std::string&)>& choose,
                  const std::string& description) {
    const auto set = [name, names, choose](const std::string& text) {
      check_name(name, text, names);
      choose(text);
    };
    app.add_option_function<std::string>(name, set, wrapped(description, kHelpWidth))
        ->type_name("NAME");
  }

  void add_switch(const std::string& name, bool& value, const std::string& description) {
    app.add_flag(name, value, wrapped(description, kHelpWidth))->disable_flag_override();
  }

  void add_picture_options() {
    app.add_option("-o,--output", a.outputs,
                   wrapped("Picture to write, .png (sRGB, 8 bit) or .exr (linear, float32); "
                           "repeatable; default <scene>.png in the working directory",
                           kHelpWidth))
        ->type_name("FILE")
        ->take_all()
        ->expected(1);
    add_number("--width", a.width, 1, kMaxImageSize,
               "Picture width in pixels; default: the scene's");
    add_number("--height", a.height, 1, kMaxImageSize,
               "Picture height in pixels; default: the scene's");
    add_switch("--variance", a.variance,
               "Add the layers variance.R/G/B, sample variance of the pixel mean, to an EXR. It "
               "takes the samples as independent: with --sampler sobol it is too large");
  }

  void add_sampling_options() {
    add_number("--spp", a.spp, 1, kMaxSpp, "Samples per pixel; default: the scene's");
    add_choice("--light-sampling", direct_method_names(),
               [this](const std::string& name) { a.light_sampling = name; },
               "How direct light is sampled: " + alternatives(direct_method_names()) +
                   " (see below); default: the scene's");
    add_number("--line-rays", a.line_rays, 1, kMaxLineRays,
               fmt::format("Rays per chord of the methods that count rays; default {}",
                           a.line_rays));
    add_number("--max-depth", a.max_depth, 1, kMaxDepth,
               "Surfaces that a path may be reflected at; 1 = direct light only; default "
               "unlimited, with Russian roulette");
    add_number("--seed", a.seed, 0, UINT64_MAX, "Seed of the random numbers; default 0");
    add_choice("--sampler", {"sobol", "independent"},
               [this](const std::string& name) { a.sampler = *sampler_kind(name); },
               "Source of the random numbers: sobol (default) or independent");
    add_number("--threads", a.threads, 1, kMaxThreads,
               "Threads; default: as many as the machine has. The picture does not depend on it");
  }

  void add_report_options() {
    add_text("--stats", a.stats, "FILE.json", "Write statistics as JSON");
    add_choice("--progress", {"auto", "bar", "jsonl", "none"},
               [this](const std::string& name) { a.progress = *progress_style(name); },
               "How progress is shown on stderr: auto (default; a bar on a terminal, else "
               "nothing), bar, jsonl (one JSON object per line) or none");
    add_switch("--quiet", a.quiet,
               "Print nothing but errors and warnings: no progress, no summary, no file names");
    add_switch("--strict", a.strict,
               "Repaired or dropped input is an error (exit code 3), and so are non-finite "
               "samples (exit code 1)");
    app.add_option_function<std::string>(
           "--replay", [this](const std::string& text) { a.replay = parse_replay(text); },
           "Trace only this sample of this pixel and print its vertices")
        ->type_name("X,Y,SAMPLE");
    add_switch("--list-methods", list_methods, "List the values of --light-sampling");
    add_switch("--version", version, "Version, build, instruction set and libraries");
  }

  std::string help() const { return app.help() + "Light sampling methods:\n" + methods_text(); }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames()) result.push_back("--" + name);
    return result;
  }
};

[[noreturn]] void throw_usage(const std::string& what) {
  throw UsageError(what + " (--help lists all options)");
}

[[noreturn]] void throw_not_expected(const OptionList& options, const std::string& argument) {
  if (!argument.starts_with("-"))
    throw_usage(fmt::format("{}: one scene file is enough, and it is {}", argument,
                            options.a.scene));
  const std::string name = argument.substr(0, argument.find('='));
  throw_usage(fmt::format("{}: no such option; the nearest is {}", name,
                          nearest_name(name, options.names())));
}

// CLI11's texts speak of its own terms, so only the option's name is taken from them.
[[noreturn]] void throw_mismatch(const std::string& what) {
  std::string name = what.substr(0, what.find_first_of(": "));
  if (!name.starts_with("-")) name = "--" + name;
  if (what.ends_with("missing")) throw_usage(name + ": needs a value");
  if (what.find("At Most") != std::string::npos) throw_usage(name + ": given more than once");
  throw_usage(name + ": takes no value");
}

void parse(OptionList& options, const Arguments& arguments) {
  try {
    options.app.parse(std::vector<std::string>(arguments.values.rbegin(), arguments.values.rend()));
  } catch (const CLI::ExtrasError&) {
    throw_not_expected(options, options.app.remaining().front());
  } catch (const CLI::ArgumentMismatch& error) {
    throw_mismatch(error.what());
  } catch (const CLI::CallForHelp&) {
    options.a.text = options.help();
  } catch (const CLI::ParseError& error) {
    throw_usage(error.what());
  }
}

}  // namespace

RenderArguments parse_render_arguments(const Arguments& arguments) {
  RenderArguments a;
  a.threads = default_threads();
  OptionList options(a);
  parse(options, arguments);
  if (a.text) return a;
  if (options.list_methods) a.text = methods_text();
  if (options.version) a.text = version_text();
  if (a.text) return a;
  if (a.scene.empty()) throw_usage("no scene file given");
  for (const std::string& output : a.outputs) image_format(output);
  return a;
}

RenderOptions render_options(const RenderArguments& a, const SceneFile& scene) {
  RenderOptions o;
  o.width = a.width.value_or(scene.width);
  o.height = a.height.value_or(scene.height);
  o.spp = a.spp.value_or(static_cast<std::uint64_t>(scene.spp));
  o.shade.method =
      find_direct_method(a.light_sampling.empty() ? scene.light_sampling : a.light_sampling);
  o.shade.max_depth = a.max_depth;
  o.shade.line_rays = a.line_rays;
  o.sampler = a.sampler;
  o.seed = a.seed;
  o.threads = a.threads;
  return o;
}

}  // namespace raytracing
