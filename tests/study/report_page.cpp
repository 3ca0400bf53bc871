// Writes the example report for report_browser_test.py: report_page FILE.html
#include <fstream>
#include <iostream>

#include "study/report_example.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: report_page FILE.html\n";
    return 2;
  }
  std::ofstream file(argv[1], std::ios::binary);
  file << raytracing::report_html(raytracing::example_report());
  return file.flush() ? 0 : 4;
}
