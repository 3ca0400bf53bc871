#include "raytracing/io/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>

#include "raytracing/io/errors.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

namespace fs = std::filesystem;

// Each test has an empty folder.
class FileTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return temp_ / name; }
  std::string put(const std::string& name, const std::string& bytes) const {
    return temp_.write(name, bytes);
  }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const TempDir temp_;
  const fs::path folder_{temp_.path()};
};

// Drops the rights of root, which may write anything, for a while.
class WithoutRights {
 public:
  WithoutRights() : root_(::geteuid() == 0) {
    if (root_ && ::seteuid(65534) != 0) std::abort();
  }
  ~WithoutRights() {
    if (root_ && ::seteuid(0) != 0) std::abort();
  }

 private:
  bool root_;
};

template <typename Error, typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(FileTest, ReadsEveryByte) {
  const std::string bytes("a\0b\r\n\xff", 6);
  EXPECT_EQ(read_file(put("some", bytes)), bytes);
  EXPECT_EQ(read_file(put("empty", "")), "");
  const std::string large(3'000'001, 'x');
  EXPECT_EQ(read_file(put("large", large)), large);
}

TEST_F(FileTest, ReadingFailsWithNameAndReason) {
  const auto message = [](const std::string& file) {
    return message_of<InputError>([&] { read_file(file); });
  };
  EXPECT_EQ(message(path("absent")), path("absent") + ": No such file or directory");
  EXPECT_EQ(message(folder_.string()), folder_.string() + ": Is a directory");
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(message(path("pipe")), path("pipe") + ": not a regular file");  // and does not wait
}

TEST_F(FileTest, OutputAppearsWhenComplete) {
  const std::string target = path("out.png");
  {
    OutputFile output(target);
    EXPECT_EQ(output.path(), target);
    EXPECT_FALSE(fs::exists(target));
    const fs::path temporary = output.temporary_path();
    EXPECT_EQ(temporary.parent_path(), folder_);
    EXPECT_TRUE(temporary.filename().string().starts_with(".out.png."));
    EXPECT_EQ(temporary.extension(), ".tmp");
    output.write("first and longer");
    output.write("second");
    EXPECT_FALSE(fs::exists(target));
    output.commit();
    EXPECT_EQ(output.temporary_path(), "");
  }
  EXPECT_EQ(read_file(target), "second");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, OutputReplacesAnOlderFile) {
  const std::string target = put("out", "old");
  OutputFile output(target);
  output.write("new");
  EXPECT_EQ(read_file(target), "old");
  output.commit();
  EXPECT_EQ(read_file(target), "new");
}

TEST_F(FileTest, NothingIsLeftWithoutCommit) {
  const std::string target = put("out", "old");
  { OutputFile(target).write("new"); }
  EXPECT_EQ(read_file(target), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, MovingKeepsOneOwner) {
  std::optional<OutputFile> kept;
  {
    OutputFile output(path("out"));
    kept.emplace(std::move(output));
  }
  EXPECT_TRUE(fs::exists(kept->temporary_path()));
  kept->write("x");
  kept->commit();
  kept.reset();
  EXPECT_EQ(read_file(path("out")), "x");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, TwoOutputsToOneNameDoNotMeet) {
  OutputFile a(path("out")), b(path("out"));
  EXPECT_NE(a.temporary_path(), b.temporary_path());
  a.write("a");
  b.write("b");
  b.commit();
  a.commit();
  EXPECT_EQ(read_file(path("out")), "a");
}

TEST_F(FileTest, PermissionsFollowTheUmask) {
  const mode_t before = ::umask(027);
  OutputFile output(path("out"));
  output.commit();
  ::umask(before);
  struct stat info {};
  ASSERT_EQ(::stat(path("out").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640u);
}

TEST_F(FileTest, LongNamesAndNamesWithoutFolder) {
  const std::string name(250, 'n');
  OutputFile output(path(name));
  output.commit();
  EXPECT_TRUE(fs::exists(path(name)));
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  OutputFile("bare").commit();
  fs::current_path(before);
  EXPECT_TRUE(fs::exists(path("bare")));
}

TEST_F(FileTest, BadTargetsAreFoundAtOnce) {
  const auto message = [](const std::string& target) {
    return message_of<OutputError>([&] { OutputFile{target}; });
  };
  EXPECT_EQ(message(folder_.string()), folder_.string() + ": cannot be written: Is a directory");
  EXPECT_EQ(message(path("no/out")),
            path("no/out") + ": cannot be written: No such file or directory");
  EXPECT_EQ(message(put("file", "") + "/out"),
            path("file/out") + ": cannot be written: Not a directory");
  EXPECT_EQ(message(""), ": cannot be written: not a file name");
  EXPECT_EQ(message(path("new/")), path("new/") + ": cannot be written: not a file name");
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(message(path("pipe")), path("pipe") + ": cannot be written: not a regular file");
}

TEST_F(FileTest, ReadOnlyTargetsAreFoundAtOnce) {
  const std::string target = put("out", "old");
  const auto message = [](const std::string& name) {
    const WithoutRights without_rights;
    return message_of<OutputError>([&] { OutputFile{name}; });
  };
  fs::permissions(target, fs::perms::owner_read | fs::perms::others_read);
  fs::permissions(folder_, fs::perms::all);
  EXPECT_EQ(message(target), target + ": cannot be written: Permission denied");
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                               fs::perms::others_exec);
  EXPECT_EQ(message(path("new")), path("new") + ": cannot be written: Permission denied");
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(entries(), 1u);
}

// A limit on the size of files simulates a full disk: write() is incomplete, then fails.
TEST_F(FileTest, FailedWriteIsAnErrorAndLeavesTheOldFile) {
  const std::string target = put("out", "old");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  {
    OutputFile output(target);
    message = message_of<OutputError>([&] { output.write(std::string(5000, 'x')); });
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, target + ": cannot be written: File too large");
  EXPECT_EQ(read_file(target), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(FileTest, CommitFailsWhenTheTemporaryFileIsGone) {
  OutputFile output(path("out"));
  fs::remove(output.temporary_path());
  EXPECT_THROW(output.commit(), OutputError);
}

TEST_F(FileTest, NothingHappensAfterCommit) {
  OutputFile output(path("out"));
  output.commit();
  EXPECT_THROW(output.commit(), OutputError);
  EXPECT_THROW(output.write("x"), OutputError);
}

TEST(HashBytes, IsDefinedByTheBytesAlone) {
  EXPECT_EQ(hash_bytes(""), hash_bytes(std::string_view()));
  EXPECT_EQ(hash_bytes("path tracer"), 0x973c1d3ba1fc6830u);  // on every machine
  const std::string shifted = "xpath tracer";
  EXPECT_EQ(hash_bytes(std::string_view(shifted).substr(1)), hash_bytes("path tracer"));
}

TEST(HashBytes, TellsSimilarInputsApart) {
  std::set<std::uint64_t> seen;
  std::string zeros;
  for (int length = 0; length < 100; ++length, zeros += '\0') {
    EXPECT_TRUE(seen.insert(hash_bytes(zeros, 1)).second) << length;
  }
  EXPECT_NE(hash_bytes("b", hash_bytes("a")), hash_bytes("a", hash_bytes("b")));
  EXPECT_NE(hash_bytes("b", hash_bytes("a")), hash_bytes("", hash_bytes("ab")));
  EXPECT_NE(hash_bytes("a", 1), hash_bytes("a", 2));
}

// Flipping an input bit must flip each output bit about half of the time.
TEST(HashBytes, EveryBitCounts) {
  std::mt19937 random(1);
  for (const std::size_t length : {8u, 13u, 40u}) {
    for (std::size_t bit = 0; bit < 8 * length; ++bit) {
      int turned = 0;
      for (int i = 0; i < 64; ++i) {
        std::string bytes(length, '\0');
        for (char& c : bytes) c = static_cast<char>(random() & 0xff);
        const std::uint64_t before = hash_bytes(bytes);
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
        turned += std::popcount(before ^ hash_bytes(bytes));
      }
      EXPECT_NEAR(turned / 64.0, 32, 3) << "byte " << bit / 8 << " of " << length;
    }
  }
}

}  // namespace
}  // namespace raytracing
