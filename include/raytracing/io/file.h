#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace raytracing {

/// Returns the bytes of a regular file. Throws InputError ("file: reason") for a missing or
/// unreadable file, a directory, or a failed read.
std::string read_file(const std::string& path);

/// Returns a 64-bit hash of bytes that distinguishes versions of a file; not cryptographic. Several
/// files are chained by passing the hash so far as `seed`.
std::uint64_t hash_bytes(std::string_view bytes, std::uint64_t seed = 0);

/// A file that appears under its final name only when complete: it is written under a temporary
/// name in the same folder, then renamed. Destroying it before commit() removes the temporary file.
class OutputFile {
 public:
  /// Creates the temporary file, so that an unwritable folder is found before any work is done.
  /// Throws OutputError, also if `path` is a directory.
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&&) = delete;

  const std::string& path() const { return path_; }
  const std::string& temporary_path() const { return temporary_; }

  /// Replaces the temporary file's contents. Throws OutputError.
  void write(std::string_view bytes);
  /// Flushes the temporary file to the disk and renames it to path(). Throws OutputError.
  void commit();

 private:
  std::string path_;
  std::string temporary_;  ///< empty once committed or moved from
};

/// Writes a whole file by an OutputFile. Throws OutputError.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace raytracing
