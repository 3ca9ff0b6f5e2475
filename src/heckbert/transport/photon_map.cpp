#include <heckbert/transport/photon_map.h>

#include <oneapi/tbb/parallel_for.h>
#include <nanoflann.hpp>

namespace heckbert::transport {

struct PhotonMap::Tree {
  // What nanoflann asks of a set of points.
  const std::vector<Photon>& photons;
  std::size_t kdtree_get_point_count() const { return photons.size(); }
  float kdtree_get_pt(std::size_t number, std::size_t axis) const {
    return photons[number].position[static_cast<glm::length_t>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }

  using Index = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Tree>, Tree, 3, std::uint32_t>;
  Index index;

  explicit Tree(const std::vector<Photon>& all) : photons(all), index(3, *this) {}
};

struct PhotonMap::Row {
  std::vector<Photon> photons;
  std::vector<Way> ways;
  std::uint64_t rays = 0;

  /// Leaves a photon wherever the walk came to a surface that is not all specular.
  void add(const World& world, const LightWalk& light, bool caustics_only) {
    if (!light.start || light.vertices.empty()) return;
    auto way = static_cast<std::uint32_t>(ways.size());
    ways.push_back({.event = {light.start->kind, world.labels.light(light.start->source)}});
    for (std::size_t i = 0; i < light.vertices.size(); ++i) {
      const LightVertex& at = light.vertices[i];
      if (at.surface && can_be_joined(at) && (!caustics_only || i > 0))
        photons.push_back({at.hit.position, at.to_light, at.hit.normal_geometric, at.throughput, at.rivals, way,
                           static_cast<std::uint16_t>(i + 1)});
      if (i == light.events.size()) break;
      if (caustics_only && taxonomy::facts(light.events[i].symbol).letter == 'D') break;
      ways.push_back({light.events[i], way});
      way = static_cast<std::uint32_t>(ways.size() - 1);
    }
  }
};

PhotonMap::PhotonMap(const World& world, const SamplePlan& plan, int sample, const PhotonSettings& settings)
    : radius_(settings.radius),
      walks_(world.window.pixel_count() * static_cast<std::size_t>(settings.walks_per_pixel)) {
  const record::Window& window = world.window;
  std::vector<Row> rows(static_cast<std::size_t>(window.height()));
  tbb::parallel_for(window.y0, window.y1, [&](int y) {
    Row& row = rows[static_cast<std::size_t>(y - window.y0)];
    for (int x = window.x0; x < window.x1; ++x) {
      Sampler of_walk(plan, x, y, sample);
      for (int i = 0; i < settings.walks_per_pixel; ++i) {
        of_walk = of_walk.split();
        Sampler sampler = of_walk;
        row.add(world, walk_from_light(world, row.rays, sampler, settings.particles), settings.caustics_only);
      }
    }
  });
  for (Row& row : rows) {
    const auto first = static_cast<std::uint32_t>(ways_.size());
    for (Photon photon : row.photons) {
      photon.way += first;
      photons_.push_back(photon);
    }
    for (Way way : row.ways) {
      if (way.before != kNone) way.before += first;
      ways_.push_back(way);
    }
    row = Row();
  }
  tree_ = std::make_unique<Tree>(photons_);
}

PhotonMap::~PhotonMap() = default;

void PhotonMap::find(glm::vec3 position, std::vector<const Photon*>& found) const {
  found.clear();
  if (photons_.empty()) return;
  thread_local std::vector<std::pair<std::uint32_t, float>> near;
  nanoflann::RadiusResultSet<float, std::uint32_t> within(radius_ * radius_, near);  // which empties it
  tree_->index.findNeighbors(within, &position.x, nanoflann::SearchParams());
  for (const auto& [number, squared_distance] : near) found.push_back(&photons_[number]);
}

taxonomy::WordTrie::Node PhotonMap::spell(Walk& walk, taxonomy::WordTrie::Node node, const Photon& photon) const {
  for (std::uint32_t way = photon.way; way != kNone; way = ways_[way].before)
    node = walk.step(node, ways_[way].event.symbol, ways_[way].event.label);
  return node;
}

}  // namespace heckbert::transport
