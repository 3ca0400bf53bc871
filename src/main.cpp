#include "cli/app.h"

int main(int argc, char** argv) { return raytracing::run(argc, argv); }
