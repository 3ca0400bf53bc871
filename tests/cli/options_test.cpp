// The options of the command line: each is in the help and is parsed, and each invalid one is
// reported in one line.

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <regex>
#include <sstream>

#include "raytracing/integrator/direct_method.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

/// A plausible value of each option of the contract; "" for those without a value.
const std::map<std::string, std::string> kContract{
    {"--scene", kCornell},
    {"--output", "x.png"},
    {"--width", "3"},
    {"--height", "3"},
    {"--layers", "depth,variance"},
    {"--float", ""},
    {"--variance", ""},
    {"--spp", "1"},
    {"--line-rays", "2"},
    {"--max-depth", "1"},
    {"--light-sampling", std::string(direct_methods().front().name)},
    {"--seed", "7"},
    {"--threads", "2"},
    {"--sampler", "independent"},
    {"--stats", "x.json"},
    {"--progress", "jsonl"},
    {"--quiet", ""},
    {"--strict", ""},
    {"--replay", "0,0,0"},
    {"--list-methods", ""},
    {"--version", ""},
    {"--help", ""},
    {"--replicates", "1"},
    {"--reuse", "1"},
};

/// The options that the help lists at the start of its lines, and whether they have a value.
std::map<std::string, bool> options_in(const std::string& help) {
  std::map<std::string, bool> options;
  const std::regex option("\n  (?:-[a-z], ?)?(--[a-z-]+)( [A-Z])?");
  for (std::sregex_iterator i(help.begin(), help.end(), option), end; i != end; ++i)
    options[(*i)[1]] = (*i)[2].matched;
  return options;
}

/// The subcommands that the help lists.
std::vector<std::string> subcommands() {
  std::vector<std::string> names;
  const std::string help = CliFolder().run({"--help"}).out;
  std::istringstream lines(help.substr(help.find("\nSubcommands ") + 1));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty())
    names.push_back(line.substr(0, line.find(' ')));
  return names;
}

TEST(Options, HelpListsTheContract) {
  const CliFolder folder;
  const RunResult help = folder.run({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_EQ(help.err, "");
  std::map<std::string, bool> contract;
  for (const auto& [name, value] : kContract) contract[name] = !value.empty();
  EXPECT_EQ(options_in(help.out), contract);
  EXPECT_NE(help.out.find("-o,--output"), std::string::npos);
  EXPECT_EQ(help.out, folder.run({"render", "-h"}).out);
}

TEST(Options, HelpFitsATerminal) {
  for (const std::string& command : subcommands()) {
    const std::string help = CliFolder().run({command, "--help"}).out;
    std::istringstream lines(help.substr(0, help.find("Methods for direct light:")));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
  }
}

TEST(Options, HelpNamesTheSubcommands) {
  const std::string help = CliFolder().run({"--help"}).out;
  const std::size_t list = help.find("\nSubcommands ");
  ASSERT_NE(list, std::string::npos) << help;
  EXPECT_NE(help.find("\nrender "), std::string::npos) << help;
}

TEST(Options, EachOneOfTheHelpIsRead) {
  const CliFolder folder;
  for (const auto& [name, has_value] : options_in(folder.run({"--help"}).out)) {
    ASSERT_TRUE(kContract.contains(name)) << name;
    std::vector<std::string> arguments;
    // The scene comes as a positional argument unless it is the option under test.
    if (name != "--scene") arguments.push_back(kCornell);
    for (const char* small : {"--width", "--height", "--spp"})
      if (name != small) arguments.insert(arguments.end(), {small, "1"});
    std::vector<std::string> joined = arguments;
    const std::string value = kContract.at(name);
    arguments.push_back(name);
    if (!value.empty()) arguments.push_back(value);
    const RunResult run = folder.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
    if (value.empty()) continue;
    joined.push_back(name + "=" + value);
    EXPECT_EQ(folder.run(joined).exit_code, 0) << name;
  }
}

TEST(Options, ListOfMethodsIsTheTable) {
  const CliFolder folder;
  const RunResult list = folder.run({"--list-methods"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(list.err, "");
  EXPECT_EQ(lines_of(list.out), direct_methods().size());
  std::istringstream lines(list.out);
  for (const DirectMethod& method : direct_methods()) {
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line.substr(0, line.find(' ')), method.name);
    EXPECT_NE(line.find(method.summary), std::string::npos) << line;
    EXPECT_NE(line.find(method.cost), std::string::npos) << line;
    EXPECT_EQ(line.find(" BIASED") != std::string::npos, !method.unbiased) << line;
  }
  const std::string help = folder.run({"--help"}).out;
  EXPECT_NE(help.find(list.out), std::string::npos) << help;
}

// An option with a value is refused without one, and a flag with one: both are known to the parser.
TEST(Options, EachOneOfEachHelpIsParsed) {
  const CliFolder folder;
  EXPECT_GE(subcommands().size(), 4u);
  for (const std::string& command : subcommands()) {
    const std::string help = folder.run({command, "--help"}).out;
    EXPECT_GT(options_in(help).size(), 5u) << help;
    for (const auto& [name, has_value] : options_in(help)) {
      if (name == "--help") continue;
      const RunResult run = folder.run({command, has_value ? name : name + "=3"});
      EXPECT_EQ(run.exit_code, 2) << command << " " << name;
      EXPECT_EQ(run.err, "Raytracing: " + name +
                             (has_value ? ": needs a value" : ": takes no value") +
                             " (--help lists all options)\n");
    }
  }
}

TEST(Options, VersionNamesTheBuild) {
  const RunResult run = CliFolder().run({"--version"});
  EXPECT_EQ(run.exit_code, 0);
  for (const char* part :
       {"Raytracing ", "build: ", "instruction set: ", "Embree", "OpenImageIO", "OBJ"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
}

struct Wrong {
  std::vector<std::string> arguments;
  std::string message;  ///< the beginning of the line after "Raytracing: "
};

void expect_usage_error(const CliFolder& folder, const Wrong& wrong) {
  std::string line;
  for (const std::string& a : wrong.arguments) line += " " + a;
  RunOptions options;
  options.folder = folder.folder.path();
  options.limit = 10;  // a value that is accepted by mistake may start a long rendering
  const RunResult run = run_program(wrong.arguments, options);
  EXPECT_EQ(run.exit_code, 2) << line;
  EXPECT_EQ(run.out, "") << line;
  EXPECT_EQ(run.err.substr(0, 12 + wrong.message.size()), "Raytracing: " + wrong.message) << line;
  EXPECT_EQ(lines_of(run.err), 1u) << run.err;
  EXPECT_LE(run.err.size(), 200u) << run.err;
  EXPECT_EQ(folder.names(), std::vector<std::string>{}) << line;
}

TEST(WrongOptions, NumbersOutOfRange) {
  const CliFolder folder;
  for (const auto& [option, low, high, too_high] : std::vector<std::array<std::string, 4>>{
           {"--spp", "1", "1099511627776", "1099511627777"},
           {"--width", "1", "65536", "65537"},
           {"--height", "1", "65536", "65537"},
           {"--max-depth", "1", "1073741824", "1073741825"},
           {"--threads", "1", "1024", "1025"},
           {"--line-rays", "1", "65536", "65537"},
           {"--replicates", "1", "65536", "65537"},
           {"--seed", "0", "18446744073709551615", "18446744073709551616"}}) {
    const std::string range = " is not between " + low + " and " + high + "\n";
    for (const std::string& value :
         {std::string("-1"), too_high, std::string("99999999999999999999999")})
      expect_usage_error(folder, {{kCornell, option, value}, option + ": " + value + range});
    if (low == "1") expect_usage_error(folder, {{kCornell, option, "0"}, option + ": 0" + range});
    for (const std::string value : {"x", "1.5", "1e3", "0x10", "+1", "-", "1 ", "-x"})
      expect_usage_error(folder, {{kCornell, option + "=" + value},
                                  option + ": '" + value + "' is not an integer\n"});
    expect_usage_error(folder, {{kCornell, option}, option + ": needs a value"});
  }
}

/// The first method's name with one letter too many.
std::string misspelt() { return std::string(direct_methods().front().name) + "x"; }

TEST(WrongOptions, Names) {
  const CliFolder folder;
  for (const Wrong& wrong : std::vector<Wrong>{
           {{kCornell, "--light-sampling", misspelt()},
            "--light-sampling: must be " + std::string(direct_methods().front().name)},
           {{kCornell, "--sampler", "Sobol"},
            "--sampler: must be sobol or independent, not 'Sobol'; the nearest is sobol\n"},
           {{kCornell, "--progress", "json"},
            "--progress: must be auto, bar, jsonl or none, not 'json'; the nearest is jsonl\n"},
           {{kCornell, "--light-samplin", "point"},
            "--light-samplin: unknown option; the nearest is --light-sampling"},
           {{kCornell, "--seet=3"}, "--seet: unknown option; the nearest is --seed"},
           {{"--sead", "3"}, "--sead: unknown option; the nearest is --seed"},
           {{kCornell, "-x"}, "-x: unknown option"}})
    expect_usage_error(folder, wrong);
  const RunResult run = folder.run({kCornell, "--light-sampling", misspelt()});
  EXPECT_TRUE(run.err.ends_with(", not '" + misspelt() + "'; the nearest is " +
                                std::string(direct_methods().front().name) + "\n"))
      << run.err;
}

TEST(WrongOptions, ShapeOfTheCommandLine) {
  const CliFolder folder;
  for (const Wrong& wrong : std::vector<Wrong>{
           {{}, "no scene file given"},
           {{"render"}, "no scene file given"},
           {{kCornell, "b.toml"}, "b.toml: one argument too many; the scene file is " + kCornell},
           {{kCornell, "--scene", kCornell}, "--scene: given more than once"},
           {{kCornell, "--seed", "1", "--seed", "2"}, "--seed: given more than once"},
           {{kCornell, "--quiet=3"}, "--quiet: takes no value"},
           {{kCornell, "--output"}, "--output: needs a value"},
           {{kCornell, "-o"}, "--output: needs a value"},
           {{kCornell, "--stats"}, "--stats: needs a value"},
           {{kCornell, "-o", "x.foo"}, "x.foo: the name of an image must end in one of .exr"},
           {{kCornell, "-o", ".png"}, ".png: "},
           {{kCornell, "--replay", "1,2"}, "--replay: '1,2' is not of the form X,Y,SAMPLE"},
           {{kCornell, "--replay", "1,2,3,4"}, "--replay: '1,2,3,4' is not of the form X,Y,SAMPLE"},
           {{kCornell, "--replay", "1,2,x"}, "--replay: 'x' is not an integer"},
           {{kCornell, "--replay", "-1,0,0"}, "--replay: -1 is not between 0 and 65535"},
           {{kCornell, "--replay", "65536,0,0"}, "--replay: 65536 is not between 0 and 65535"}})
    expect_usage_error(folder, wrong);
}

TEST(WrongOptions, ReplayOutsideOfThePicture) {
  const CliFolder folder;
  for (const char* replay : {"12,0,0", "0,8,0", "0,0,2"}) {
    const RunResult run = folder.render({"--quiet", "--replay", replay});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.err, std::string("Raytracing: --replay: ") + replay +
                           " lies outside 12x8 pixels and 2 spp\n");
    EXPECT_EQ(run.out, "");
  }
}

TEST(WrongOptions, ReplicatesThatDoNotDivideTheSamples) {
  const CliFolder folder;
  for (const auto& [spp, replicates] : {std::pair{"10", "4"}, {"2", "3"}, {"1", "2"}}) {
    const RunResult run = folder.render({"--quiet", "--spp", spp, "--replicates", replicates});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.err, std::string("Raytracing: --replicates: ") + replicates +
                           " does not divide " + spp + " samples per pixel\n");
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

TEST(Options, LeadingZerosAreDecimal) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"--spp", "010", "--stats", "s.json"}).exit_code, 0);
  EXPECT_EQ(folder.json("s.json")["spp"], 10);
}

TEST(Options, FullStandardOutputIsAnError) {
  for (const std::string option : {"--list-methods", "--help", "chart --help"}) {
    const RunResult run =
        run_any({"/bin/sh", "-c", std::string(RAYTRACING_PROGRAM) + " " + option + " > /dev/full"});
    EXPECT_EQ(run.exit_code, 4) << option;
    EXPECT_EQ(run.err, "Raytracing: standard output: cannot be written\n") << option;
  }
}

}  // namespace
}  // namespace raytracing
