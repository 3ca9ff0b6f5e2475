#include <heckbert/transport/labels.h>

#include <cassert>
#include <map>

#include <heckbert/taxonomy/label.h>

namespace heckbert::transport {

namespace {

/// As it will be read back from a record's words, where control characters are blanks.
std::string as_written(const std::string& name) {
  return taxonomy::read_label(taxonomy::write_label(name), 0)->label;
}

const std::string& first_given(const std::string& name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

/// By number of the shape: see Hit::shape.
std::vector<std::string> object_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Shape& shape : scene.shapes) names.push_back(first_given(shape.label, shape.name));
  for (const Group& group : scene.groups)
    for (const Shape& shape : group.shapes)
      names.push_back(first_given(shape.label, first_given(shape.name, group.name)));
  return names;
}

}  // namespace

std::string write(const LabelRule& rule) {
  std::string text;
  for (const LabelKindFacts& kind : kLabelKinds) {
    const bool has = kind.rule.light_groups ? rule.light_groups : rule.events == kind.rule.events;
    if (has) text += (text.empty() ? "" : ",") + std::string(kind.name);
  }
  return text;
}

Labels::Labels(const Scene& scene, const Tracer& tracer, const LabelRule& rule)
    : by_object_(rule.events == EventLabels::Object), first_medium_(scene.media.data()) {
  std::map<std::string, Id> ids{{"", taxonomy::WordTrie::kNoLabel}};
  const auto number_of = [&](const std::string& name) {
    const auto [known, is_new] = ids.try_emplace(as_written(name), static_cast<Id>(names_.size()));
    if (is_new) names_.push_back(known->first);
    return known->second;
  };
  const std::vector<std::string> objects = object_names(scene);
  if (by_object_)
    for (const std::string& name : objects) of_surface_.push_back(number_of(name));
  if (rule.events == EventLabels::Material)
    for (const Material& material : scene.materials)
      of_surface_.push_back(number_of(first_given(material.label, material.name)));
  if (rule.events != EventLabels::None)
    for (const Medium& medium : scene.media) of_medium_.push_back(number_of(medium.name));

  if (!rule.light_groups) return;
  using Type = LightSource::Type;
  const auto ids_of = [&](Type type) -> std::vector<Id>& { return of_light_[static_cast<std::size_t>(type)]; };
  for (const Emitter& emitter : tracer.emitters()) {
    const Material& material = scene.materials[emitter.material];
    ids_of(Type::Emitter)
        .push_back(number_of(first_given(material.light_group, first_given(objects[emitter.shape], material.name))));
  }
  for (const PointLight& light : scene.point_lights) ids_of(Type::Point).push_back(number_of(light.light_group));
  for (const SpotLight& light : scene.spot_lights) ids_of(Type::Spot).push_back(number_of(light.light_group));
  for (const DistantLight& light : scene.distant_lights) ids_of(Type::Distant).push_back(number_of(light.light_group));
  ids_of(Type::Environment).push_back(number_of("environment"));
}

void Labels::number_in(taxonomy::WordTrie& trie) const {
  for (Id id = 0; id < names_.size(); ++id) {
    [[maybe_unused]] const Id numbered = trie.label(names_[id]);
    assert(numbered == id && "the trie had labels of its own");
  }
}

}  // namespace heckbert::transport
