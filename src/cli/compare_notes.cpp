#include "compare_notes.h"

#include <fmt/format.h>

#include "raytracing/render/provenance.h"
#include "raytracing/study/metrics/overlap.h"

namespace raytracing {
namespace {

void add_notes_on(const NamedImage& named, const RunFacts& facts, std::vector<std::string>& notes) {
  const auto& [path, image] = named;
  for (const std::string& note : image.notes)
    notes.push_back(fmt::format("note: {}: {}", path, note));
  if (facts.light_sampling_biased == true)
    notes.push_back(fmt::format(
        "note: {}: rendered by {}, a biased method that does not converge to the true image", path,
        facts.light_sampling.value_or("an unknown method")));
  if (facts.complete == false)
    notes.push_back(fmt::format("warning: {}: the rendering was stopped early", path));
  if (has_correlated_pixels(facts))
    notes.push_back(fmt::format("note: {}: {}", path, *facts.pixel_correlation));
  if (image.integer_bits > 0)
    notes.push_back(fmt::format("note: {}: {} bits per channel; values above 1 are clipped", path,
                                image.integer_bits));
}

// What the two headers state differently although it should be the same for a fair comparison.
void add_differences(const RunFacts& x, const RunFacts& r, std::vector<std::string>& notes) {
  const auto differ = [](const auto& a, const auto& b) { return a && b && *a != *b; };
  if (differ(x.scene_hash, r.scene_hash))
    notes.push_back(fmt::format("warning: the images show different scenes (scene_hash {} and {})",
                                *x.scene_hash, *r.scene_hash));
  if (x.max_depth && r.max_depth && to_text(*x.max_depth) != to_text(*r.max_depth))
    notes.push_back(fmt::format("warning: the images differ in depth (max_depth {} and {})",
                                to_text(*x.max_depth), to_text(*r.max_depth)));
  if (differ(x.width, r.width) || differ(x.height, r.height))
    notes.push_back(fmt::format(
        "warning: the images were rendered at different sizes ({}x{} and {}x{})",
        x.width.value_or(0), x.height.value_or(0), r.width.value_or(0), r.height.value_or(0)));
  if (differ(x.light_sampling, r.light_sampling))
    notes.push_back(fmt::format("note: the images were rendered by different methods ({} and {})",
                                *x.light_sampling, *r.light_sampling));
  if (x.scene_hash && x.scene_hash == r.scene_hash && x.seed && x.seed == r.seed && x.sampler &&
      x.sampler == r.sampler)
    notes.emplace_back(
        "note: both images were rendered with the same seed; their errors are not independent");
}

void add_window_note(const ImageData& test, const ImageData& reference, const PixelWindow& window,
                     std::vector<std::string>& notes) {
  if (window_of(test) == window && window_of(reference) == window) return;
  notes.push_back(
      fmt::format("note: only the {}x{} pixels at {},{} that both images have are compared",
                  window.width, window.height, window.x, window.y));
}

}  // namespace

std::vector<std::string> comparison_notes(const NamedImage& test, const NamedImage& reference,
                                          const PixelWindow& window) {
  std::vector<std::string> notes;
  const RunFacts x = facts_of(test.image.metadata), r = facts_of(reference.image.metadata);
  add_differences(x, r, notes);
  add_notes_on(test, x, notes);
  add_notes_on(reference, r, notes);
  add_window_note(test.image, reference.image, window, notes);
  return notes;
}

}  // namespace raytracing
