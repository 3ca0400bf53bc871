#pragma once

#include <string>
#include <vector>

#include "raytracing/study/stress_run.h"

namespace raytracing {

/// The cells of one case, setting by setting.
struct StressTable {
  const StressCase* stress_case;
  std::vector<const DirectMethod*> methods;
  std::vector<const StressCell*> cells;  ///< by setting, then by method

  std::size_t settings() const { return cells.size() / methods.size(); }
  const StressCell& at(std::size_t setting, std::size_t method) const {
    return *cells[setting * methods.size() + method];
  }
  /// The settings at which the method got this verdict.
  std::vector<const StressCell*> with(std::size_t method, Verdict verdict) const;
  /// The worst verdict of the method.
  Verdict worst(std::size_t method) const;
};

std::vector<StressTable> stress_tables(const StressResult& result);

}  // namespace raytracing
