#pragma once
// The paths of one pixel of a render that is over, traced again: random numbers are a function of seed, pixel and
// sample number, so the same walks are taken, and this time their vertices are kept.

#include <vector>

#include <heckbert/record/path_sink.h>
#include <heckbert/taxonomy/word.h>
#include <heckbert/transport/render.h>
#include <heckbert/transport/trail.h>

namespace heckbert::transport {

struct RetracedPath {
  taxonomy::Word word;
  int sample = 0;
  record::Technique technique = record::Technique::Hit;
  Rgb value;                          ///< as it was recorded: for one sample, every weight applied
  std::vector<TrailVertex> vertices;  ///< light, then one for each event, in the order of the word; the eye left out
};

/// All paths that the render found at a pixel, by sample; what the recorder rejects is left out. Takes the settings of
/// that render, without a sample map. Cost: that of the pixel's samples, and of making the scene ready.
/// Errors: as render(), and std::invalid_argument for an algorithm that walks from the light.
std::vector<RetracedPath> retrace(const Scene& scene, const RenderSettings& settings, int x, int y);

}  // namespace heckbert::transport
