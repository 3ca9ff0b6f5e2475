#include <heckbert/transport/reach.h>

#include <algorithm>

namespace heckbert::transport {

bool has_technique(Reach reach, const taxonomy::Word& word, std::size_t light_vertices) {
  const std::size_t events = word.events.size(), eye_vertices = events + 2 - light_vertices;
  const auto is_mirror = [](taxonomy::Symbol s) { return taxonomy::facts(s).letter == 'S'; };
  const auto matt = std::find_if_not(word.events.rbegin(), word.events.rend(), is_mirror);
  const auto mirrors = static_cast<std::size_t>(matt - word.events.rbegin());  // next to the eye
  const auto is_diffuse = [](taxonomy::Symbol s) { return taxonomy::facts(s).letter == 'D'; };
  const bool asks_for_light = light_vertices == 1 && eye_vertices >= 2;  // from a surface, not from the eye itself
  const bool is_mirrored_light = light_vertices == 0 && mirrors == events;
  const bool ends_at_matt = light_vertices > 0 && eye_vertices == mirrors + 2;
  switch (reach) {
    case Reach::Hit:
      return light_vertices == 0;
    case Reach::NextEvent:
      return asks_for_light;
    case Reach::Eye:
      return light_vertices == 0 || asks_for_light;
    case Reach::Shiny:
      return (light_vertices == 0 || asks_for_light) &&
             std::none_of(word.events.begin() + static_cast<std::ptrdiff_t>(light_vertices), word.events.end(),
                          is_diffuse);
    case Reach::Matt:
      return is_mirrored_light || (ends_at_matt && light_vertices == 1);
    case Reach::Light:
      return eye_vertices <= 1;
    case Reach::Both:
      return true;
    case Reach::VirtualLights:
      return is_mirrored_light || ends_at_matt;
    case Reach::Merging:
      return is_mirrored_light;
  }
  return false;
}

}  // namespace heckbert::transport
