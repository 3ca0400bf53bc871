// Writes the example reports for report_browser_test.py: report_page FILE.html [tables]
#include <fstream>
#include <iostream>
#include <string_view>

#include "study/report_example.h"

int main(int argc, char** argv) {
  const bool tables = argc == 3 && std::string_view(argv[2]) == "tables";
  if (argc != 2 && !tables) {
    std::cerr << "usage: report_page FILE.html [tables]\n";
    return 2;
  }
  std::ofstream file(argv[1], std::ios::binary);
  file << raytracing::report_html(tables ? raytracing::report_of_tables()
                                         : raytracing::example_report());
  return file.flush() ? 0 : 4;
}
