#include <heckbert/transport/radiosity.h>

#include <limits>

#include <heckbert/transport/frame.h>
#include <heckbert/transport/specular_walk.h>

namespace heckbert::transport {

using taxonomy::WordTrie;

namespace {

/// The light that is stored at a vertex, as it leaves towards the eye.
void show(const World& world, Walk& walk, const Vertex& vertex, WordTrie::Node node, Rgb throughput, int depth,
          const RadiositySolution& solution) {
  Rgb reflectance;
  for (const Lobe& lobe : vertex.lobes()) reflectance += diffuse_reflectance(lobe, vertex.wo);
  if (is_black(reflectance)) return;
  const auto place = solution.find(vertex.hit);
  if (!place) return;
  const Rgb factor = throughput * reflectance * (1 / kPi);
  // From the limit on nothing is left out: there the walk counts all that it finds as cut off.
  const std::size_t room = depth >= world.max_depth ? std::numeric_limits<std::size_t>::max()
                                                    : static_cast<std::size_t>(world.max_depth - depth);
  for (std::size_t i = 0; i < solution.lights().size(); ++i) {
    const RadiosityLight& light = solution.lights()[i];
    WordTrie::Node scattered = node;
    for (std::size_t bounce = 1; bounce <= light.irradiance.size(); ++bounce) {
      const Rgb value = factor * solution.irradiance(i, bounce, *place);
      if (bounce > room) {
        walk.cut_off += value;
        continue;
      }
      scattered = walk.step(scattered, taxonomy::Symbol::Dr, WordTrie::kNoLabel);
      if (is_black(value)) continue;
      const record::Technique technique{static_cast<std::uint16_t>(bounce + 1), true};
      walk.find({walk.step(scattered, light.kind, WordTrie::kNoLabel), value, technique});
    }
  }
}

}  // namespace

void trace_radiosity(const World& world, Walk& walk, Ray ray, const RadiositySolution& solution, bool through_mirrors) {
  walk_to_matt(
      world, walk, ray,
      [&](const Vertex& vertex, WordTrie::Node node, Rgb throughput, int depth) {
        show(world, walk, vertex, node, throughput, depth, solution);
      },
      through_mirrors);
}

}  // namespace heckbert::transport
