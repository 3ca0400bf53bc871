#pragma once
// The declarations of the methods, made from the table: a method's own file defines the function of
// its name, which returns its row.

#include "raytracing/integrator/direct_method.h"

namespace raytracing::methods {

#define METHOD(name) DirectMethod name();
#include "table.inc"
#undef METHOD

}  // namespace raytracing::methods
