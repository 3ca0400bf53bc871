#pragma once

namespace raytracing {

/// Returns the weight of the balance heuristic (Veach & Guibas 1995, eq. 14) for a sample of the
/// density `pdf` when another strategy, with one sample too, chooses it with the density
/// `other_pdf`. Both densities must have the same measure; one of them must be positive.
inline float balance_heuristic(float pdf, float other_pdf) { return pdf / (pdf + other_pdf); }

}  // namespace raytracing
