#pragma once

#include <functional>
#include <string>
#include <vector>

namespace raytracing {

/// The folder that a command writes its results to, with the pictures that gnuplot draws there.
class ResultFolder {
 public:
  using Announce = std::function<void(const std::string& name)>;

  /// Creates the folder where it is missing; `announce` receives the name of each complete file.
  /// Throws OutputError.
  ResultFolder(std::string path, Announce announce);

  const std::string& path() const { return path_; }
  /// Writes and announces a file. Throws OutputError.
  void write(const std::string& name, const std::string& bytes) const;
  /// Runs gnuplot on a script of the folder, which draws the `pictures`, and announces those. False
  /// when gnuplot is not in PATH. Throws OutputError when it fails.
  bool draw(const std::string& script, const std::vector<std::string>& pictures) const;

 private:
  std::string path_;
  Announce announce_;
};

/// The files <plot>.svg and <plot>.png of each plot.
std::vector<std::string> picture_files(const std::vector<std::string>& plots);

/// Runs gnuplot on <folder>/<script>. False when it is not in PATH. Throws OutputError when it
/// fails.
bool run_gnuplot(const std::string& folder, const std::string& script);

/// The text as a string constant of gnuplot, between single quotes.
std::string gnuplot_string(const std::string& text);

/// A line of a script that sets the variable `name` to an array of these string constants.
std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts);

}  // namespace raytracing
