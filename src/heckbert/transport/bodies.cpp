#include <heckbert/transport/bodies.h>

#include <algorithm>

namespace heckbert::transport {

namespace {

int priority(const Scene& scene, std::uint32_t material) {
  return scene.materials[material].interior->priority;
}

/// The index of the interface that bounds a body; 0 where it has none of its own.
float index_of(const Material& material) {
  for (const Lobe& lobe : material.lobes)
    if (const auto* glass = std::get_if<Dielectric>(&lobe))
      return glass->ior;
    else if (const auto* rough = std::get_if<RoughDielectric>(&lobe))
      return rough->ior;
  return 0;
}

}  // namespace

std::size_t Bodies::place_of(std::uint32_t material) const {
  for (std::size_t i = count_; i-- > 0;)
    if (materials_[i] == material) return i;
  return count_;
}

bool Bodies::hides(const Scene& scene, std::uint32_t body, std::uint32_t material) const {
  return body == material || priority(scene, body) > priority(scene, material);
}

void Bodies::cross(const Scene& scene, std::uint32_t material, bool from_front) {
  if (!scene.materials[material].interior) return;
  if (from_front) {
    if (count_ == kMost) return;
    std::size_t place = count_++;
    for (; place > 0 && priority(scene, materials_[place - 1]) > priority(scene, material); --place)
      materials_[place] = materials_[place - 1];
    materials_[place] = material;
  } else if (const std::size_t place = place_of(material); place < count_) {
    std::copy(materials_.begin() + place + 1, materials_.begin() + count_, materials_.begin() + place);
    --count_;
  }
}

bool Bodies::shows(const Scene& scene, std::uint32_t material, bool from_front) const {
  if (!scene.materials[material].interior) return true;
  if (from_front) return count_ == 0 || !hides(scene, materials_[count_ - 1], material);
  const std::size_t place = place_of(material);
  if (place == count_) return true;
  return place + 1 == count_ && (place == 0 || materials_[place - 1] != material);
}

const Medium* Bodies::medium(const Scene& scene) const {
  const std::optional<std::uint32_t> here =
      count_ == 0 ? scene.medium : scene.materials[materials_[count_ - 1]].interior->medium;
  return here ? &scene.media[*here] : nullptr;
}

float Bodies::index_in_front(const Scene& scene, std::uint32_t material) const {
  for (std::size_t i = count_; i-- > 0;)
    if (const float index = index_of(scene.materials[materials_[i]]); materials_[i] != material && index > 0)
      return index;
  return 1;
}

}  // namespace heckbert::transport
