// Invalid input ends with exit code 3, an output that cannot be written with 4, each with one line.
// Nothing is left behind, and no older file is lost.

#include <gtest/gtest.h>

#include "support/cli_folder.h"

namespace raytracing {
namespace {

TEST(BadInput, ASceneThatIsNotThere) {
  const CliFolder folder;
  expect_one_line(folder.run({"./nope.toml"}), 3, "./nope.toml: No such file or directory");
  expect_one_line(folder.run({"--scene", "."}), 3, ".: Is a directory");
  const std::string endless(300, 'x');  // longer than file names may be
  for (const std::string& name : {std::string("rendr"), endless}) {
    const RunResult run = folder.run({name, "--spp", "1"});
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_TRUE(run.err.starts_with("Raytracing: " + name + ": no such scene file; looked for "))
        << run.err;
    EXPECT_TRUE(run.err.ends_with("; the nearest subcommand is render\n")) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    EXPECT_EQ(run.out, "");
  }
  expect_one_line(folder.run({"comapre", "a.exr", "b.exr"}), 2,
                  "comapre: no such subcommand or scene file; the nearest subcommand is compare "
                  "(--help lists all options)");
  EXPECT_EQ(folder.names(), Names{});
}

TEST(BadInput, ABrokenSceneIsReportedWithItsLocation) {
  const CliFolder folder;
  const std::string camera = "[camera]\norigin = [0,0,1]\ntarget = [0,0,0]\n";
  folder.folder.write("syntax.toml", camera + "[film\n");
  folder.folder.write("key.toml", camera + "[film]\nwidht = 4\n");
  folder.folder.write("model.toml", camera + "[[models]]\nobj = 'broken.obj'\n");
  folder.folder.write("broken.obj", "v 0 0 0\nv 1 0 nan\n");
  folder.folder.write("missing.toml", camera + "[[models]]\nobj = 'nope.obj'\n");
  for (const auto& [scene, place] :
       std::vector<std::pair<std::string, std::string>>{{"syntax.toml", "syntax.toml:4:"},
                                                        {"key.toml", "key.toml:5:1: "},
                                                        {"model.toml", "broken.obj:2:7: "},
                                                        {"missing.toml", "missing.toml:5:7: "}}) {
    const RunResult run = folder.run({scene, "-o", "x.png"});
    EXPECT_EQ(run.exit_code, 3) << scene;
    EXPECT_TRUE(run.err.starts_with("Raytracing: " + place)) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u) << run.err;
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(folder.names(),
            (Names{"broken.obj", "key.toml", "missing.toml", "model.toml", "syntax.toml"}));
}

TEST(NonFiniteSamples, AreCountedNamedAndWithStrictAnError) {
  const CliFolder folder;
  folder.write_overflowing_scene();
  for (const std::string reuse : {"1", "16"}) {
    const std::vector<std::string> lax = {"s.toml", "--spp",   "4",  "--stats",
                                          "s.json", "--reuse", reuse};
    const RunResult run = folder.run(lax);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("--replay "), std::string::npos) << run.err;
    const nlohmann::json stats = folder.json("s.json");
    EXPECT_GT(stats["non_finite_samples"], 0);
    std::uint64_t causes = 0;
    for (const auto& [name, count] : stats.items())
      if (name.starts_with("non_finite_") && name != "non_finite_samples")
        causes += count.get<std::uint64_t>();
    EXPECT_EQ(causes, stats["non_finite_samples"]);

    // Replaying the sample that was named shows the cause that was named.
    const std::size_t named = run.err.find("non-finite sample (");
    ASSERT_NE(named, std::string::npos) << run.err;
    const std::string line = run.err.substr(named, run.err.find('\n', named) - named);
    const std::string cause = line.substr(line.find('(') + 1, line.find(')') - line.find('(') - 1);
    const std::size_t sample = line.find("--replay ") + 9;
    const RunResult replay = folder.run({"s.toml", "--spp", "4", "--reuse", reuse, "--replay",
                                         line.substr(sample, line.find(' ', sample) - sample)});
    EXPECT_NE(replay.out.find("not finite: " + cause + "\n"), std::string::npos) << replay.out;
    std::vector<std::string> strict = lax;
    strict.push_back("--strict");
    EXPECT_EQ(folder.run(strict).exit_code, 1);
  }
}

TEST(BadInput, StrictRefusesWhatWasRepaired) {
  const CliFolder folder;
  folder.folder.write("s.toml",
                      "[film]\nwidth = 2\nheight = 2\n[camera]\norigin = [0,0,1]\n"
                      "target = [0,0,0]\n[[models]]\nobj = 'm.obj'\n");
  folder.folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 2 4 3\n");
  const RunResult lax = folder.run({"s.toml", "--quiet", "-o", "x.png"});
  EXPECT_EQ(lax.exit_code, 0);
  EXPECT_EQ(lax.err.substr(0, 17), "m.obj:5:1: repair") << lax.err;
  folder.folder.write("x.png", "old");
  const RunResult strict = folder.run({"s.toml", "--quiet", "--strict", "-o", "x.png"});
  EXPECT_EQ(strict.exit_code, 3);
  EXPECT_TRUE(strict.err.ends_with("Raytracing: --strict: records repaired: 1, dropped: 0\n"))
      << strict.err;
  EXPECT_EQ(folder.bytes("x.png"), "old");
  EXPECT_EQ(folder.names(), (Names{"m.obj", "s.toml", "x.png"}));
  folder.folder.write("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(folder.run({"s.toml", "--strict", "-o", "x.png"}).exit_code, 0);
}

// This rendering would take hours: only an error found before it begins ends in time.
RunResult long_render(const CliFolder& folder, std::vector<std::string> outputs) {
  outputs.insert(outputs.end(), {"--spp", "1000000000", "--quiet"});
  RunOptions options;
  options.folder = folder.folder.path();
  options.limit = 20;
  outputs.insert(outputs.begin(), kCornell);
  return run_program(outputs, options);
}

TEST(BadOutput, NeverReplacesAnInputOrAnotherOutput) {
  const CliFolder folder;
  folder.folder.write("s.toml",
                      "[camera]\norigin = [0,0,1]\ntarget = [0,0,0]\n[[models]]\n"
                      "obj = 'm.obj'\n");
  folder.folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.folder.write("m.mtl", "newmtl a\n");
  const Names before = folder.names();
  for (const Names& outputs : {Names{"--stats", "s.toml"},
                               {"--stats", "./m.obj"},
                               {"--stats", "m.mtl"},
                               {"-o", "a.png", "--stats", "./a.png"},
                               {"-o", "a.png", "-o", "./a.png"},
                               {"--stats", "s.png"}}) {
    Names arguments{"s.toml", "--quiet"};
    arguments.insert(arguments.end(), outputs.begin(), outputs.end());
    expect_one_line(folder.run(arguments), 2,
                    outputs.back() + ": would be overwritten: it is named twice");
  }
  EXPECT_EQ(folder.names(), before);
}

// Messages are lost then, but neither exit codes nor pictures.
TEST(BadOutput, AStderrThatIsClosedOrFull) {
  for (const std::string target : {"/dev/full", "&-"}) {
    const CliFolder folder;
    RunOptions options;
    options.folder = folder.folder.path();
    const auto run = [&](const std::string& arguments) {
      const std::string program = RAYTRACING_PROGRAM;
      return run_any({"/bin/sh", "-c", program + " " + arguments + " 2>" + target}, options);
    };
    EXPECT_EQ(run("--spp x").exit_code, 2) << target;
    EXPECT_EQ(run("./nope.toml").exit_code, 3) << target;
    EXPECT_EQ(run(kCornell + " -o nope/x.png").exit_code, 4) << target;
    EXPECT_EQ(run(kCornell + " --spp 1 --width 4 --height 4 --progress bar -o x.exr").exit_code, 0)
        << target;
    EXPECT_EQ(folder.names(), Names{"x.exr"}) << target;
  }
}

TEST(BadOutput, LineBreaksInNamesDoNotBreakTheMessage) {
  const CliFolder folder;
  const RunResult run = folder.render({"-o", "a\nb.foo"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(lines_of(run.err), 1u) << run.err;
}

TEST(BadOutput, IsFoundBeforeRendering) {
  const CliFolder folder;
  std::filesystem::create_directory(folder.folder / "d.png");
  std::filesystem::create_symlink("/dev/full", folder.folder / "full.exr");
  folder.folder.write("x.png", "old");
  const Names before = folder.names();
  for (const auto& [name, reason] : std::vector<std::pair<std::string, std::string>>{
           {"nope/x.png", "No such file or directory"},
           {"d.png", "Is a directory"},
           {"x.png/y.png", "Not a directory"},
           {"/proc/x.png", ""},
           {"full.exr", "not a regular file"},
           {std::string(300, 'x') + ".png", "File name too long"}}) {
    for (const std::vector<std::string>& outputs :
         {std::vector<std::string>{"-o", name},
          {"-o", "x.png", "-o", name},
          {"-o", name, "-o", "x.png", "--stats", "s.json"},
          {"-o", "x.png", "--stats", name}}) {
      const RunResult run = long_render(folder, outputs);
      EXPECT_EQ(run.exit_code, 4) << name;
      EXPECT_TRUE(run.err.starts_with("Raytracing: " + name + ": cannot be written: " + reason))
          << run.err;
      EXPECT_EQ(lines_of(run.err), 1u) << run.err;
      EXPECT_EQ(run.out, "");
      EXPECT_EQ(folder.names(), before) << name;
      EXPECT_EQ(folder.bytes("x.png"), "old");
    }
  }
}

TEST(BadOutput, TheDefaultNameIsCheckedToo) {
  const CliFolder folder;
  std::filesystem::create_directory(folder.folder / "cornell.png");
  expect_one_line(long_render(folder, {}), 4, "cornell.png: cannot be written: Is a directory");
}

TEST(BadOutput, AWriteThatFailsAtTheEndKeepsTheOldPicture) {
  // A limit of the file size stands for a full disk. TIFF goes through a file in memory, which the
  // limit stops first.
  for (const std::string name : {"x.exr", "x.png", "x.tif", "x.hdr"}) {
    const CliFolder folder;
    folder.folder.write(name, "old");
    RunOptions options;
    options.folder = folder.folder.path();
    const RunResult run =
        run_any({"/bin/sh", "-c",
                 "ulimit -f 8; exec " + std::string(RAYTRACING_PROGRAM) + " " + kCornell +
                     " --quiet --width 200 --height 100 --spp 1 -o " + name},
                options);
    EXPECT_EQ(run.exit_code, 4);
    if (name != "x.tif") {
      EXPECT_TRUE(
          run.err.ends_with("Raytracing: " + name + ": cannot be written: File too large\n"))
          << run.err;
    }
    EXPECT_EQ(folder.bytes(name), "old");
    EXPECT_EQ(folder.names(), Names{name});
  }
}

}  // namespace
}  // namespace raytracing
