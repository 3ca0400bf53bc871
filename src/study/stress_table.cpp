#include "stress_table.h"

#include <algorithm>

namespace raytracing {

std::vector<const StressCell*> StressTable::with(std::size_t method, Verdict verdict) const {
  std::vector<const StressCell*> result;
  for (std::size_t s = 0; s < settings(); ++s)
    if (at(s, method).verdict == verdict) result.push_back(&at(s, method));
  return result;
}

Verdict StressTable::worst(std::size_t method) const {
  Verdict result = Verdict::holds;
  for (std::size_t s = 0; s < settings(); ++s) result = std::max(result, at(s, method).verdict);
  return result;
}

std::vector<StressTable> stress_tables(const StressResult& result) {
  std::vector<StressTable> tables;
  for (const StressCell& cell : result.cells) {
    if (tables.empty() || tables.back().stress_case != cell.stress_case)
      tables.push_back({cell.stress_case, {}, {}});
    StressTable& table = tables.back();
    if (std::find(table.methods.begin(), table.methods.end(), cell.method) == table.methods.end())
      table.methods.push_back(cell.method);
    table.cells.push_back(&cell);
  }
  return tables;
}

}  // namespace raytracing
