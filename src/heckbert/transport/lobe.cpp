#include <heckbert/transport/lobe.h>

#include <type_traits>

#include <heckbert/transport/coat.h>
#include <heckbert/transport/fresnel.h>
#include <heckbert/transport/lobe_diffuse.h>
#include <heckbert/transport/lobe_glossy.h>
#include <heckbert/transport/lobe_rough_dielectric.h>
#include <heckbert/transport/overload.h>

namespace heckbert::transport {

using taxonomy::Symbol;

namespace {

template <class T, class... Ts>
inline constexpr bool is_one_of = (std::is_same_v<T, Ts> || ...);

/// What kind of lobe each type is: the one place that says so.
template <class T>
struct Kind {
  static constexpr bool dirac = is_one_of<T, Mirror, Dielectric, ThinDielectric>;
  static constexpr bool diffuse = is_one_of<T, Lambert, OrenNayar, DiffuseTransmission, CoatedDiffuse>;
  static constexpr bool reflects = !dirac && !is_one_of<T, DiffuseTransmission>;
  static constexpr bool transmits = is_one_of<T, DiffuseTransmission, RoughDielectric>;
  static constexpr bool branching = is_one_of<T, Dielectric, ThinDielectric, RoughDielectric>;

  /// Can the lobe, having no Dirac, take wo to wi?
  static bool connects(glm::vec3 wo, glm::vec3 wi) {
    return wo.z > 0 && ((reflects && wi.z > 0) || (transmits && wi.z < 0));
  }
};

template <class T>
using KindOf = Kind<std::remove_cvref_t<T>>;

/// std::visit, with a short cut: most lobes of most scenes are Lambert's, and a test that goes as expected is cheaper
/// than a jump through a table.
template <class Visitor>
decltype(auto) visit_lobe(const Visitor& visitor, const Lobe& lobe) {
  if (const auto* lambert = std::get_if<Lambert>(&lobe)) [[likely]]
    return visitor(*lambert);
  return std::visit(visitor, lobe);
}

}  // namespace

bool is_delta(const Lobe& lobe) {
  return visit_lobe([](const auto& l) { return KindOf<decltype(l)>::dirac; }, lobe);
}

bool transmits(const Lobe& lobe) {
  return visit_lobe([](const auto& l) { return KindOf<decltype(l)>::transmits; }, lobe);
}

bool is_branching(const Lobe& lobe) {
  return visit_lobe([](const auto& l) { return KindOf<decltype(l)>::branching; }, lobe);
}

Symbol letter(const Lobe& lobe, bool transmitted) {
  const bool diffuse = visit_lobe([](const auto& l) { return KindOf<decltype(l)>::diffuse; }, lobe);
  if (diffuse) return transmitted ? Symbol::Dt : Symbol::Dr;
  return transmitted ? Symbol::Gt : Symbol::Gr;
}

LobeValue value_and_pdf(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi, bool front) {
  return visit_lobe(
      [&](const auto& l) {
        if constexpr (!KindOf<decltype(l)>::dirac)
          if (KindOf<decltype(l)>::connects(wo, wi))
            return LobeValue{evaluate_lobe(l, wo, wi, front), pdf_of_lobe(l, wo, wi, front)};
        return LobeValue{};
      },
      lobe);
}

float pdf_solid_angle(const Lobe& lobe, glm::vec3 wo, glm::vec3 wi, bool front) {
  return visit_lobe(
      [&](const auto& l) {
        if constexpr (!KindOf<decltype(l)>::dirac)
          if (KindOf<decltype(l)>::connects(wo, wi)) return pdf_of_lobe(l, wo, wi, front);
        return 0.0f;
      },
      lobe);
}

glm::vec3 sample_direction(const Lobe& lobe, glm::vec3 wo, glm::vec3 u, bool front) {
  return visit_lobe(
      [&](const auto& l) {
        if constexpr (KindOf<decltype(l)>::dirac) {
          return glm::vec3(0);
        } else {
          const glm::vec3 wi = sample_lobe(l, wo, u, front);
          return KindOf<decltype(l)>::connects(wo, wi) ? wi : glm::vec3(0);
        }
      },
      lobe);
}

float selection_weight(const Lobe& lobe, glm::vec3 wo) {
  return visit_lobe(
      Overload{
          [](const Lambert& l) { return max_channel(l.albedo); },
          [](const OrenNayar& l) { return max_channel(l.albedo); },
          [](const DiffuseTransmission& l) { return max_channel(l.transmittance); },
          [&](const CoatedDiffuse& l) { return max_channel(l.tint * l.albedo) * (1.0f - coat_albedo(l.coat, wo.z)); },
          [&](const Mirror& l) { return max_channel(l.tint * fresnel(l.fresnel, wo.z)); },
          [&](const MicrofacetReflection& l) { return max_channel(l.tint * fresnel(l.fresnel, wo.z)); },
          [](const Phong& l) { return max_channel(l.reflectance); },
          // A dielectric splits one between two parts; how is decided when it is followed.
          [](const auto& l) { return std::max(max_channel(l.reflection_tint), max_channel(l.transmission_tint)); },
      },
      lobe);
}

Rgb diffuse_albedo(const Lobe& lobe) {
  return visit_lobe(Overload{
                        [](const Lambert& l) { return l.albedo; },
                        [](const OrenNayar& l) { return l.albedo; },
                        [](const CoatedDiffuse& l) { return l.tint * l.albedo; },
                        [](const auto&) { return Rgb{}; },
                    },
                    lobe);
}

float radiance_compression(const Lobe& lobe, bool front) {
  const auto* glass = std::get_if<RoughDielectric>(&lobe);
  if (glass == nullptr) return 1;
  return front ? 1.0f / (glass->ior * glass->ior) : glass->ior * glass->ior;
}

void scale(Lobe& lobe, Rgb factor) {
  std::visit(Overload{
                 [&](Lambert& l) { l.albedo *= factor; },
                 [&](OrenNayar& l) { l.albedo *= factor; },
                 [&](DiffuseTransmission& l) { l.transmittance *= factor; },
                 [&](CoatedDiffuse& l) { l.tint *= factor; },
                 [&](Mirror& l) { l.tint *= factor; },
                 [&](MicrofacetReflection& l) { l.tint *= factor; },
                 [&](Phong& l) { l.reflectance *= factor; },
                 [&](auto& l) {
                   l.reflection_tint *= factor;
                   l.transmission_tint *= factor;
                 },
             },
             lobe);
}

DeltaBranches delta_branches(const Lobe& lobe, glm::vec3 wo, bool front) {
  return std::visit(Overload{
                        [&](const Mirror& l) { return branches_of(l, wo); },
                        [&](const Dielectric& l) { return branches_of(l, wo, front); },
                        [&](const ThinDielectric& l) { return branches_of(l, wo); },
                        [](const auto&) { return DeltaBranches{}; },
                    },
                    lobe);
}

}  // namespace heckbert::transport
