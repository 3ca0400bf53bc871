// Faults of the environment: unreadable files, missing assets, full disks, more threads than there
// is work. Each ends with the right exit code and one line.

#include <gtest/gtest.h>
#include <unistd.h>

#include "support/compare_folder.h"

namespace raytracing {
namespace {

const std::string kScene =
    "[film]\nwidth = 4\nheight = 4\n[camera]\norigin = [0,0,2]\ntarget = [0,0,0]\n";
const std::string kSquare = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

/// Runs the program with files limited to so many blocks of 512 bytes, which stands for a full
/// disk.
RunResult with_full_disk(const CliFolder& folder, const Names& arguments, int blocks) {
  RunOptions options;
  options.folder = folder.folder.path();
  Names command{"/bin/sh", "-c",
                "trap '' XFSZ; ulimit -f " + std::to_string(blocks) + "; exec \"$@\"", "sh",
                RAYTRACING_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_any(command, options);
}

// Reading /proc/self/mem fails for every user, also for the superuser.
TEST(Faults, UnreadableFilesAreNamed) {
  const CompareFolder folder;
  folder.write("a.exr", rgb_picture(1, 1, {1, 1, 1}));
  folder.folder.write("model.toml", kScene + "[[models]]\nobj = '/proc/self/mem'\n");
  folder.folder.write("folder.toml", kScene + "[[models]]\nobj = '.'\n");
  for (const auto& [arguments, begin] : std::vector<std::pair<Names, std::string>>{
           {{"/proc/self/mem"}, "/proc/self/mem: Input/output error"},
           {{"model.toml"}, "model.toml:8:7: /proc/self/mem: Input/output error"},
           {{"folder.toml"}, "folder.toml:8:7: .: Is a directory"},
           {{"compare", "/proc/self/mem", "a.exr"}, "/proc/self/mem: Input/output error"},
           {{"compare", "a.exr", "."}, ".: Is a directory"},
           {{"compare", "a.exr", "a.exr", "--mask", "nope.png"},
            "nope.png: No such file or directory"},
           {{"chart", "/proc/self/mem", "--out=c"}, "/proc/self/mem: Input/output error"},
           {{"chart", "./nope.toml", "--out=c"}, "./nope.toml: No such file or directory"}}) {
    const RunResult run = folder.run(arguments);
    EXPECT_EQ(run.exit_code, 3) << begin;
    EXPECT_EQ(run.err, "Raytracing: " + begin + "\n");
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(folder.names(), (Names{"a.exr", "folder.toml", "model.toml"}));
  }
}

TEST(Faults, MissingMaterialsAndTexturesAreReported) {
  const CliFolder folder;
  folder.folder.write("s.toml", kScene + "[[models]]\nobj = 'm.obj'\n");
  folder.folder.write("m.obj", "mtllib no.mtl there.mtl\n" + kSquare +
                                   "usemtl a\nf 1 2 3 4\nusemtl b c\nf 1 2 3 4\nusemtl d\n"
                                   "f 1 2 3 4\n");
  folder.folder.write("there.mtl", "newmtl a\nKd 1\nmap_Kd nowhere.png\n");
  const RunResult run = folder.run({"s.toml", "--spp=1"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("m.obj:1:8: repaired: material library missing: 'no.mtl'\n"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("repaired: material not defined: 'b c' (the first of 2)\n"),
            std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("there.mtl:3:1: ignored: MTL key 'map_Kd'\n"), std::string::npos);
  EXPECT_EQ(folder.run({"s.toml", "--spp=1", "--strict"}).exit_code, 3);
  std::filesystem::create_directory(folder.folder / "no.mtl");
  const RunResult directory = folder.run({"s.toml", "--spp=1"});
  EXPECT_EQ(directory.exit_code, 3);
  EXPECT_EQ(directory.err, "Raytracing: no.mtl: Is a directory\n");
}

TEST(Faults, ALineBreakInAFileNameMakesNoSecondLine) {
  const CliFolder folder;
  folder.folder.write("s.toml", kScene + "[[models]]\nobj = \"a\\nb.obj\"\n");
  folder.folder.write("a\nb.obj", kSquare + "usemtl x\nf 1 2 3 4\n");
  const RunResult run = folder.run({"s.toml", "--spp=1", "--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_TRUE(run.err.starts_with("a b.obj:5:1: repaired: material not defined: 'x'\n")) << run.err;
}

TEST(Faults, NumbersThatAreNoneInAScene) {
  const CliFolder folder;
  for (const char* line : {"fov = nan", "up = [0, inf, 0]", "up = [0, 1e39, 0]", "fov = -1"}) {
    folder.folder.write("s.toml", kScene + line + "\n");
    const RunResult run = folder.run({"s.toml", "--spp=1"});
    EXPECT_EQ(run.exit_code, 3) << line;
    EXPECT_TRUE(run.err.starts_with("Raytracing: s.toml:7:")) << run.err;
    EXPECT_EQ(lines_of(run.err), 1u);
  }
  // The numbers are finite, but no ray can be computed from them.
  folder.folder.write("far.toml", "[camera]\norigin = [0,0,1e38]\ntarget = [0,0,-1e38]\n");
  const RunResult far = folder.run({"far.toml", "--spp=1"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_EQ(far.err,
            "Raytracing: far.toml:3:10: camera.target: these numbers are too extreme to "
            "compute camera rays\n");
  EXPECT_EQ(folder.names(), (Names{"far.toml", "s.toml"}));
}

TEST(Faults, LongTextsDoNotFillTheScreen) {
  const CliFolder folder;
  folder.folder.write("s.toml", kScene + "fov = '" + std::string(100000, 'x') + "'\n");
  const RunResult run = folder.run({"s.toml"});
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_LT(run.err.size(), 1200u);
  EXPECT_EQ(lines_of(run.err), 1u);
}

TEST(Faults, AFullDiskLeavesNothingNew) {
  const CompareFolder folder;
  folder.write("a.exr", random_picture(80, 80, 1));
  folder.write("b.exr", random_picture(80, 80, 2));
  folder.folder.write("d.exr", "old");
  const Names before = folder.names();
  for (const auto& [arguments, begin] : std::vector<std::pair<Names, std::string>>{
           {{"compare", "a.exr", "b.exr", "--diff", "d.exr"}, "d.exr"},
           {{kCornell, "--spp=1", "--width=80", "--height=80", "-o", "d.exr", "--quiet"},
            "d.exr"}}) {
    const RunResult run = with_full_disk(folder, arguments, 4);
    EXPECT_EQ(run.exit_code, 4) << run.err;
    EXPECT_EQ(run.err, "Raytracing: " + begin + ": cannot be written: File too large\n");
    EXPECT_EQ(folder.names(), before);
    EXPECT_EQ(folder.bytes("d.exr"), "old");
  }
  const RunResult chart = with_full_disk(
      folder,
      {"chart", kCornell, "--out=c", "--width=64", "--height=64", "--max-depth=1",
       "--methods=point", "--spp=1,2", "--seeds=2", "--reference-time=0.01", "--quiet"},
      8);
  EXPECT_EQ(chart.exit_code, 4) << chart.err;
  EXPECT_EQ(lines_of(chart.err), 1u) << chart.err;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.folder / "c"))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST(Faults, MoreThreadsThanWork) {
  const CliFolder folder;
  ASSERT_EQ(folder.render({"--threads=1", "-o", "one.exr"}).exit_code, 0);
  const RunResult run = folder.render({"--threads=1000", "-o", "many.exr"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const RunResult same = folder.run({"compare", "one.exr", "many.exr", "--max-relmse=0"});
  EXPECT_EQ(same.exit_code, 0) << same.out;
}

/// Runs a shell script in a folder where "full" is a disk of 48 kB in memory, which vanishes with
/// the script. Exit code 77 where this user may not mount one.
RunResult on_small_disk(const CliFolder& folder, const std::string& script) {
  RunOptions options;
  options.folder = folder.folder.path();
  const std::string own = ::geteuid() == 0 ? "unshare -m" : "unshare -rm";
  return run_any(
      {"/bin/sh", "-c", own + " true 2>/dev/null || exit 77; exec " + own + " /bin/sh -c \"$0\"",
       "mount -t tmpfs -o size=48k none full 2>/dev/null || exit 77\n" + script},
      options);
}

TEST(Faults, ASmallDiskLeavesNothingNew) {
  const CompareFolder folder;
  folder.write("a.exr", random_picture(80, 80, 1));
  folder.write("b.exr", random_picture(80, 80, 2));
  std::filesystem::create_directory(folder.folder / "full");
  const std::string render = kCornell + " --spp=1 --width=160 --height=160 --quiet -o ";
  for (const auto& [command, name] : std::vector<std::pair<std::string, std::string>>{
           {render, "full/d.exr"},
           {render, "full/d.png"},
           {"compare a.exr b.exr --diff ", "full/d.exr"}}) {
    const RunResult run = on_small_disk(
        folder, "printf old > " + name + "\n" RAYTRACING_PROGRAM " " + command + name +
                    " >/dev/null\ncode=$?\nls -A full\ncat " + name + "\nexit $code");
    if (run.exit_code == 77) GTEST_SKIP() << "this user may not mount a disk in memory";
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_EQ(run.err, "Raytracing: " + name + ": cannot be written: No space left on device\n");
    EXPECT_EQ(run.out, name.substr(5) + "\nold");
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Each thread takes a stack of 1 GB, of which a few fit into 8 GB.
TEST(Faults, FewerThreadsThanAskedFor) {
  const CliFolder folder;
  RunOptions options;
  options.folder = folder.folder.path();
  const RunResult run =
      run_any({"/bin/sh", "-c",
               "ulimit -s 1000000 && ulimit -v 8400000 && exec " RAYTRACING_PROGRAM " " + kCornell +
                   " --width=32 --height=32 --spp=2 --threads=1000 -o few.exr --stats few.json"},
              options);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const int threads = folder.json("few.json")["threads"];
  EXPECT_GE(threads, 1);
  EXPECT_LT(threads, 9);
  EXPECT_NE(run.err.find("warning: the system allows only " + std::to_string(threads) +
                         " of 1000 threads\n"),
            std::string::npos)
      << run.err;
  ASSERT_EQ(folder.render({"--width=32", "--height=32", "-o", "one.exr", "--threads=1"}).exit_code,
            0);
  const RunResult same = folder.run({"compare", "one.exr", "few.exr", "--max-relmse=0"});
  EXPECT_EQ(same.exit_code, 0) << same.out;
}

// An image of 4 billion pixels is refused before anything is rendered; no temporary file remains.
TEST(Faults, APictureLargerThanTheMemory) {
  const CliFolder folder;
  RunOptions options;
  options.folder = folder.folder.path();
  const RunResult run = run_any({"/bin/sh", "-c",
                                 "ulimit -v 8000000; exec " + std::string(RAYTRACING_PROGRAM) +
                                     " " + kCornell + " --quiet --width 65536 --height 65536"},
                                options);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.err, "Raytracing: not enough memory\n");
  EXPECT_EQ(folder.names(), Names{});
}
#endif

}  // namespace
}  // namespace raytracing
