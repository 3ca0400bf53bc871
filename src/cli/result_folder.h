#pragma once

#include <string>
#include <utility>

namespace raytracing {

/// Where a command leaves its results.
class ResultFolder {
 public:
  ResultFolder(std::string path, bool quiet) : path_(std::move(path)), quiet_(quiet) {}

  const std::string& path() const { return path_; }
  /// Creates the folder where it is missing. Throws OutputError.
  void create() const;
  /// Writes a file and prints its path. Throws OutputError.
  void write(const std::string& name, const std::string& bytes) const;
  /// Prints the path of a file that is there, unless quiet.
  void print_path(const std::string& name) const;

 private:
  std::string path_;
  bool quiet_;
};

}  // namespace raytracing
