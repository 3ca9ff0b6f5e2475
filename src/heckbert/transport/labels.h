#pragma once
// The labels of a scene's letters while it is traced: numbers in tables, by shape, material, medium and light. What
// they are called: label_rule.h.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <heckbert/taxonomy/word_trie.h>
#include <heckbert/transport/label_rule.h>
#include <heckbert/transport/lights.h>
#include <heckbert/transport/scene.h>
#include <heckbert/transport/tracer.h>

namespace heckbert::transport {

/// The label of every letter that a scene can give, as numbers of a word trie.
class Labels {
 public:
  using Id = taxonomy::WordTrie::LabelId;

  /// Refers to the scene's media, which must outlive it.
  Labels(const Scene& scene, const Tracer& tracer, const LabelRule& rule);

  /// Makes the numbers valid in a trie, which has no labels yet.
  void number_in(taxonomy::WordTrie& trie) const;

  Id surface(const Hit& hit) const {
    return of_surface_.empty() ? taxonomy::WordTrie::kNoLabel : of_surface_[by_object_ ? hit.shape : hit.material];
  }
  Id particle(const Medium& medium) const {
    return of_medium_.empty() ? taxonomy::WordTrie::kNoLabel
                              : of_medium_[static_cast<std::size_t>(&medium - first_medium_)];
  }
  Id light(LightSource source) const {
    const std::vector<Id>& ids = of_light_[static_cast<std::size_t>(source.type)];
    return ids.empty() ? taxonomy::WordTrie::kNoLabel : ids[source.index];
  }
  const std::string& name(Id id) const { return names_[id]; }

 private:
  std::vector<std::string> names_{""};  ///< by number
  bool by_object_ = false;
  std::vector<Id> of_surface_;  ///< by shape or by material; empty: events are not labelled
  const Medium* first_medium_ = nullptr;
  std::vector<Id> of_medium_;
  std::array<std::vector<Id>, kLightSourceTypes> of_light_;
};

}  // namespace heckbert::transport
