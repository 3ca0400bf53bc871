#pragma once
// What the studies share: reports in Markdown, tables for the charts, quantiles.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "raytracing/study/metrics/statistics.h"

namespace raytracing {

/// The text of a study. It goes to the standard output and, when the program is given a folder,
/// into <folder>/<name>.md; tables go beside it.
class StudyReport {
 public:
  StudyReport(int argc, char** argv, std::string name)
      : folder_(argc > 1 ? argv[1] : ""), name_(std::move(name)) {
    if (!folder_.empty()) std::filesystem::create_directories(folder_);
  }

  template <class... Arguments>
  void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    const std::string more = fmt::format(format, std::forward<Arguments>(arguments)...);
    std::fputs(more.c_str(), stdout);
    std::fflush(stdout);
    text_ += more;
  }

  /// Writes <folder>/<name>_<table>.csv.
  void write_csv(std::string_view table, const std::string& csv) const {
    write(fmt::format("{}_{}.csv", name_, table), csv);
  }
  /// Writes <folder>/<name>_style.gp, which the study's chart loads.
  void write_style(const std::string& script) const { write(name_ + "_style.gp", script); }
  /// Writes the text; call it at the end.
  void write_text() const { write(name_ + ".md", text_); }

 private:
  void write(const std::string& file_name, const std::string& text) const {
    if (folder_.empty()) return;
    const std::filesystem::path path = folder_ / file_name;
    std::ofstream file(path);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
  }

  std::filesystem::path folder_;
  std::string name_, text_;
};

/// The quartile below (0.25) or above (0.75), or any other quantile.
inline double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

}  // namespace raytracing
