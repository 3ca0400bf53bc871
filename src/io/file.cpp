#include "raytracing/io/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <bit>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "raytracing/io/errors.h"

namespace raytracing {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_input(const std::string& path, const std::string& why) {
  throw InputError(TextLocation{path}, why);
}

[[noreturn]] void fail_output(const std::string& path, const std::string& why) {
  throw OutputError(path + ": cannot be written: " + why);
}

// Closes a descriptor when it goes out of scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  // Some file systems report a failed write only here.
  int close() { return ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

// Finds a target that cannot be replaced now, not after hours of rendering. Devices and pipes are
// refused because the rename would replace them by a file.
void check_target(const std::string& path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) {
    if (errno == ENOENT) return;
    fail_output(path, reason(errno));
  }
  if (S_ISDIR(info.st_mode)) fail_output(path, reason(EISDIR));
  if (!S_ISREG(info.st_mode)) fail_output(path, "not a regular file");
  const Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) fail_output(path, reason(errno));
}

std::string temporary_name(const std::string& path) {
  static std::atomic<unsigned> counter{0};
  constexpr std::size_t kLongestName = 200;  // leaves room for the rest within 255 bytes
  const std::filesystem::path target(path);
  const std::string name =
      fmt::format(".{}.{}-{}.tmp", target.filename().string().substr(0, kLongestName), ::getpid(),
                  counter.fetch_add(1));
  return (target.parent_path() / name).string();
}

std::uint64_t load_little_endian(const char* bytes, std::size_t count) {
  static_assert(std::endian::native == std::endian::little);
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, count);
  return word;
}

}  // namespace

std::string read_file(const std::string& path) {
  // Without O_NONBLOCK, opening a pipe that nobody writes to would wait for ever.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail_input(path, reason(errno));
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail_input(path, reason(errno));
  if (S_ISDIR(info.st_mode)) fail_input(path, reason(EISDIR));
  if (!S_ISREG(info.st_mode)) fail_input(path, "not a regular file");
  // One byte more than the size shows the end of the file at once; files that grow, and those of
  // /proc that claim to be empty, are read until read() returns 0.
  std::string bytes(static_cast<std::size_t>(info.st_size) + 1, '\0');
  std::size_t used = 0;
  while (true) {
    if (used == bytes.size()) bytes.resize(2 * bytes.size() + 4096);
    const ssize_t got = ::read(file.get(), bytes.data() + used, bytes.size() - used);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_input(path, reason(errno));
    if (got == 0) break;
    used += static_cast<std::size_t>(got);
  }
  bytes.resize(used);
  return bytes;
}

// MurmurHash64A by Appleby: each word is mixed by itself, then multiplied into the state.
std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed) {
  constexpr std::uint64_t kMultiplier = 0xc6a4a7935bd1e995u;
  constexpr int kShift = 47;
  std::uint64_t hash = seed ^ (bytes.size() * kMultiplier);
  const char* at = bytes.data();
  std::size_t left = bytes.size();
  for (; left >= 8; left -= 8, at += 8) {
    std::uint64_t word = load_little_endian(at, 8) * kMultiplier;
    word ^= word >> kShift;
    hash = (hash ^ (word * kMultiplier)) * kMultiplier;
  }
  if (left > 0) hash = (hash ^ load_little_endian(at, left)) * kMultiplier;
  hash = (hash ^ (hash >> kShift)) * kMultiplier;
  return hash ^ (hash >> kShift);
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (std::filesystem::path(path_).filename().empty()) fail_output(path_, "not a file name");
  check_target(path_);
  // A name exists only if an earlier process of the same id was killed; the next one is free.
  for (int tries = 0; tries < 1000; ++tries) {
    std::string name = temporary_name(path_);
    const Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() >= 0) {
      temporary_ = std::move(name);
      return;
    }
    if (errno != EEXIST) fail_output(path_, reason(errno));
  }
  fail_output(path_, "too many temporary files in its folder");
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})) {}

void OutputFile::write(std::string_view bytes) {
  if (temporary_.empty()) fail_output(path_, "already complete");
  Descriptor file(::open(temporary_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (file.get() < 0) fail_output(path_, reason(errno));
  while (!bytes.empty()) {
    const ssize_t put = ::write(file.get(), bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) fail_output(path_, reason(put < 0 ? errno : ENOSPC));
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  if (file.close() != 0) fail_output(path_, reason(errno));
}

void OutputFile::commit() {
  if (temporary_.empty()) fail_output(path_, "already complete");
  {
    // Without fsync, a crash of the machine may leave the new name with old or no contents.
    Descriptor file(::open(temporary_.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0 || ::fsync(file.get()) != 0 || file.close() != 0)
      fail_output(path_, reason(errno));
  }
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail_output(path_, reason(errno));
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace raytracing
