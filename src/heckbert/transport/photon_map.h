#pragma once
// Photons (Jensen 1996, "Global Illumination using Photon Maps"): where the light of many walks arrived at surfaces
// that are not specular. Each photon keeps the way it came, so that light found through it has its word.
//
// A map belongs to one sample number: walks from the light for every pixel of the picture, drawn from that pixel's and
// sample's random numbers, so that the map is the same for any number of threads, and every sample number has a map of
// its own (Knaus and Zwicker 2011, "Progressive Photon Mapping: A Probabilistic Approach").

#include <cstdint>
#include <memory>
#include <vector>

#include <heckbert/transport/light_walk.h>

namespace heckbert::transport {

struct Photon {
  glm::vec3 position;
  glm::vec3 to_light;          ///< unit, to where it came from
  glm::vec3 normal;            ///< geometric, of the surface it lies on
  Rgb power;                   ///< of all walks together; divide by their number
  Rivals rivals;               ///< as its walk's vertex has them
  std::uint32_t way = 0;       ///< place in the map's ways
  std::uint16_t vertices = 0;  ///< surfaces and particles on its walk, this surface too
};

struct PhotonSettings {
  float radius = 0;            ///< within which photons are near each other
  int walks_per_pixel = 1;     ///< of world.window
  bool caustics_only = false;  ///< only what came by mirrors, glass and gloss, and not straight from the light
  Particles particles = Particles::Dim;  ///< what media do to the walks; photons lie on surfaces alone
};

class PhotonMap {
 public:
  /// The first walk of a pixel is that of its sample, where the algorithm walks from the light for each of them. Cost:
  /// n log n.
  PhotonMap(const World& world, const SamplePlan& plan, int sample, const PhotonSettings& settings);
  ~PhotonMap();
  PhotonMap(const PhotonMap&) = delete;
  PhotonMap& operator=(const PhotonMap&) = delete;

  float radius() const { return radius_; }
  std::size_t size() const { return photons_.size(); }
  std::size_t walks() const { return walks_; }
  /// All photons near a place, in no certain order; replaces what `found` had.
  void find(glm::vec3 position, std::vector<const Photon*>& found) const;
  /// The word of a path whose part up to and with the photon's surface is spelt at `node`.
  taxonomy::WordTrie::Node spell(Walk& walk, taxonomy::WordTrie::Node node, const Photon& photon) const;

 private:
  /// How a photon came: an event, and the way up to there; at last the light.
  struct Way {
    Event event{};
    std::uint32_t before = kNone;
  };
  static constexpr std::uint32_t kNone = 0xffff'ffffu;
  struct Tree;
  struct Row;

  float radius_;
  std::size_t walks_;
  std::vector<Photon> photons_;
  std::vector<Way> ways_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace heckbert::transport
