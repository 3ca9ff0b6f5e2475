#pragma once
// What a render writes behind its letters. An event is labelled with the object or with the material that it happened
// on, whichever was asked for, and a light with its group: one label per letter, and one kind of label for all events,
// so that a label always means the same. In a medium both kinds are the medium's name. What has no name stays
// unlabelled; so does every letter when nothing is asked for, at the cost of a test per letter.
//
// An object is called by its label, else by its name, else by the name of the group that it is an instance of; a
// material by its label, else by its name. A light group is what the scene calls it; else a lamp is called like the
// object that emits, or like its material where that has no name, and the environment is "environment".

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace heckbert::transport {

enum class EventLabels : std::uint8_t { None, Object, Material };

/// Which letters are labelled, and with what.
struct LabelRule {
  EventLabels events = EventLabels::None;
  bool light_groups = false;
  bool operator==(const LabelRule&) const = default;
};

struct LabelKindFacts {
  std::string_view name;  ///< as on the command line and in records
  LabelRule rule;
};

/// Every kind of label; "object" and "material" exclude each other.
inline constexpr std::array<LabelKindFacts, 3> kLabelKinds{{
    {"object", {EventLabels::Object, false}},
    {"material", {EventLabels::Material, false}},
    {"light-group", {EventLabels::None, true}},
}};

/// "object,light-group"; empty when nothing is labelled.
std::string write(const LabelRule& rule);

}  // namespace heckbert::transport
