#pragma once
// A scene as plain data: what importers fill in and integrators read. No behaviour, no Embree, no file formats.
//
// Lengths are in scene units, radiance in W sr^-1 m^-2 (or whatever unit the author thinks in: all results are linear
// in it). Directions, where they occur, point away from the surface.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <heckbert/record/rgb.h>

namespace heckbert::transport {

// ---- textures -----------------------------------------------------------------------------------------------------

/// Pixels in rows from the top, four channels (r, g, b, opacity). Bytes are 0 to 255 for 0 to 1, with the sRGB curve on
/// the three colours when `srgb`; floats are linear, whatever their range. Exactly one of the two lists is filled.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes{};
  std::vector<float> floats{};
  bool srgb = true;  ///< of `bytes`: a picture, as opposed to data such as roughness, normals or opacity
};

/// Squares of two colours; each spans half a unit of u and of v, the first at the origin.
struct Checkerboard {
  Rgb first{0.4f}, second{0.2f};
};

/// A function of the texture coordinates, repeated in both directions. u runs to the right, v upwards: (0, 0) is the
/// lower left corner of a picture, which is filtered bilinearly. Looked up at uv * scale + offset.
struct Texture {
  std::string name{};
  std::variant<Image, Checkerboard> source{};
  glm::vec2 scale{1};
  glm::vec2 offset{0};
};

enum class Channel : std::uint8_t { R, G, B, A };

/// One channel of a texture.
struct ScalarTexture {
  std::uint32_t texture = 0;  ///< index into Scene::textures
  Channel channel = Channel::R;
};

// ---- materials: a sum of lobes ------------------------------------------------------------------------------------
//
// Indices of refraction are those behind the surface relative to those in front of it. `tint` multiplies a lobe as a
// whole; in a mixture it carries the lobe's weight.

/// Schlick's approximation from the reflectance at normal incidence (Schlick 1994).
struct SchlickFresnel {
  Rgb f0{0.9f};
};
/// A metal, of complex index eta + i k.
struct ConductorFresnel {
  Rgb eta, k;
};
/// Clear varnish or plastic; what is not reflected is for other lobes to say.
struct DielectricFresnel {
  float ior = 1.5f;
};
/// How much of the light a mirror or a facet reflects by angle; a colour is the same at every angle.
using Fresnel = std::variant<Rgb, SchlickFresnel, ConductorFresnel, DielectricFresnel>;

/// How the normals of tiny facets are spread. The widths run along the tangent, which follows u of the texture
/// coordinates, and across it; both are above zero and, for artists, the square of their roughness.
struct Microfacets {
  float alpha_x = 0.1f, alpha_y = 0.1f;
  enum class Distribution : std::uint8_t { Ggx, Beckmann } distribution = Distribution::Ggx;
};

/// Diffuse reflection, albedo / pi. Letter Dr.
struct Lambert {
  Rgb albedo{0.5f};
};

/// Rough diffuse reflection: Oren and Nayar's (1994) as improved by Fujii, reciprocal and never above its albedo, which
/// it reaches at grazing angles. Letter Dr.
struct OrenNayar {
  Rgb albedo{0.5f};
  float roughness = 0.5f;  ///< 0 is Lambert's, 1 the roughest
};

/// Lambert's law on the far side: paper, leaves. Letter Dt.
struct DiffuseTransmission {
  Rgb transmittance{0.5f};
};

/// A clear layer on something else.
struct Coat {
  float ior = 1.5f;  ///< 1 to kHighestCoatIor
  float alpha = 0;   ///< width of its facets; 0: smooth
  Microfacets::Distribution distribution = Microfacets::Distribution::Ggx;
};
inline constexpr float kHighestCoatIor = 3;

/// A diffuse base below a coat: what the coat's own lobe, a Mirror or MicrofacetReflection with DielectricFresnel,
/// leaves to it, with all reflections between the two; base and coat together never reflect more than they receive.
/// Letter Dr.
struct CoatedDiffuse {
  Rgb albedo{0.5f};  ///< of the base
  Coat coat{};
  bool linear = true;  ///< false: light that bounces below the coat takes the base's colour each time, which saturates
  Rgb tint{1.0f};
};

/// Perfect mirror. Letter Sr.
struct Mirror {
  Fresnel fresnel{Rgb(1.0f)};
  Rgb tint{1.0f};
};

/// Smooth interface to a medium of index `ior`, exact Fresnel and Snell; reflection and transmission are one lobe with
/// two events, Sr and St. Tints multiply either part and are at most one.
struct Dielectric {
  float ior = 1.5f;
  Rgb reflection_tint{1.0f};
  Rgb transmission_tint{1.0f};
};

/// A sheet of glass without thickness: all reflections inside it summed, light goes straight through. Sr and St.
struct ThinDielectric {
  float ior = 1.5f;
  Rgb reflection_tint{1.0f};
  Rgb transmission_tint{1.0f};
};

/// Reflection by facets, with height-correlated Smith masking, scattered once (Walter et al. 2007, Heitz 2014).
/// Letter Gr.
struct MicrofacetReflection {
  Fresnel fresnel{SchlickFresnel{}};
  Microfacets facets{};
  Rgb tint{1.0f};
};

/// An interface of facets between two media: rough glass (Walter et al. 2007). Letters Gr and Gt.
struct RoughDielectric {
  float ior = 1.5f;
  Microfacets facets{};
  Rgb reflection_tint{1.0f};
  Rgb transmission_tint{1.0f};
};

/// Normalised modified Phong lobe (Lafortune and Willems 1994): reflectance (n+2)/2pi cos^n. Letter Gr.
struct Phong {
  Rgb reflectance{0.5f};
  float exponent = 32;
};

using Lobe = std::variant<Lambert, OrenNayar, DiffuseTransmission, CoatedDiffuse, Mirror, Dielectric, ThinDielectric,
                          MicrofacetReflection, RoughDielectric, Phong>;

/// A parameter of a lobe that is multiplied by a texture.
struct LobeTexture {
  enum class Parameter : std::uint8_t {
    Colour,          ///< albedo, reflectance, transmittance; F0 of Schlick's Fresnel; else the tint
    Weight,          ///< the whole lobe, by one channel
    OneMinusWeight,  ///< the whole lobe, by one minus that channel: the other half of a mixture
    Alpha,           ///< widths of facets or the roughness of OrenNayar, by one channel
    Roughness,       ///< widths of facets by the square of one channel
  };
  std::uint32_t lobe = 0;  ///< index into Material::lobes
  Parameter parameter = Parameter::Colour;
  ScalarTexture texture{};  ///< Colour takes all three channels
  float factor = 1;         ///< multiplies what the texture says
};

struct NormalMap {
  std::uint32_t texture = 0;  ///< x, y, z from -1 to 1 stored as 0 to 1; x along u, y along v
  float strength = 1;         ///< multiplies x and y
};

enum class Sides : std::uint8_t { Front, Both };

/// A homogeneous medium: fog, milk, the colour of glass. Coefficients are per unit of length. Light is absorbed, and
/// scattered with the phase function of Henyey and Greenstein. Letter V.
struct Medium {
  std::string name{};
  Rgb absorption{};
  Rgb scattering{};      ///< black: light is only absorbed, after Beer and Lambert
  float anisotropy = 0;  ///< mean cosine of the angle of scattering, between -1 and 1; 0: isotropic
};

/// What a closed surface encloses. Surfaces that enclose something should be closed, or what is inside leaks out.
struct Interior {
  std::optional<std::uint32_t> medium{};  ///< index into Scene::media; none: empty space
  /// Where bodies overlap, the higher one is there, and among equals the one entered last; see bodies.h.
  int priority = 0;
};

/// A surface scatters by the sum of its lobes (a dielectric tells inside from outside by the geometric normal) and may
/// emit; an emitter also reflects.
struct Material {
  std::string name{};
  std::vector<Lobe> lobes{};  ///< at most kMaxLobes; see max_albedo in material.h for the bound on their sum
  Rgb emission{};             ///< radiance; black: not a light
  Sides emission_sides = Sides::Front;
  std::optional<std::uint32_t> emission_texture{};  ///< index into Scene::textures; its colour multiplies `emission`
  /// The lecture's recursive tracer continues in the mirror direction even at a diffuse surface, weighted by this k_r;
  /// that light is no path and goes to the phantom buffer. Read by no other algorithm, and not where a mirror or glass
  /// lobe continues the ray already.
  Rgb phantom_reflectance{};
  /// k_a of the ambient term, used by the recursive tracers with an ambient light; no path either.
  std::optional<Rgb> ambient_reflectance{};  ///< unset: the sum of the diffuse albedos
  Sides lobe_sides = Sides::Both;            ///< Front: black when seen from behind
  std::vector<LobeTexture> textures{};       ///< applied to the lobes in this order
  std::optional<NormalMap> normal_map{};
  /// The share of the surface that is there; through the rest light goes straight, and no letter tells of it.
  std::optional<ScalarTexture> opacity{};
  std::optional<Interior> interior{};
  /// The surface is the boundary of its interior and nothing else: light goes straight through, and no letter tells of
  /// it. Without lobes and emission.
  bool is_index_matched = false;
  std::string label{};        ///< what words call it; empty: the name
  std::string light_group{};  ///< of the light that it emits; empty: see label_rule.h
};

inline constexpr std::size_t kMaxLobes = 8;

// ---- shapes -------------------------------------------------------------------------------------------------------

/// Triangles; front is the side from which vertices run counter-clockwise.
struct Mesh {
  std::vector<glm::vec3> positions{};
  std::vector<glm::uvec3> triangles{};
  std::vector<glm::vec3> normals{};             ///< per position, for shading; empty: flat
  std::vector<std::uint32_t> face_materials{};  ///< per triangle; empty: Shape::material for all
  std::vector<glm::vec2> texcoords{};           ///< per position; empty: (0, 0), (1, 0), (0, 1) in every triangle
};

/// Front is outside. Texture coordinates: u is the longitude about z from x over two pi, v the angle from -z over pi.
struct Sphere {
  glm::vec3 center{0};
  float radius = 1;
};

/// Flat and round; front is the side that `normal` points to.
struct Disk {
  glm::vec3 center{0};
  glm::vec3 normal{0, 0, 1};  ///< of any length
  float radius = 1;
};

using Geometry = std::variant<Mesh, Sphere, Disk>;

struct Shape {
  std::string name{};
  Geometry geometry{};
  std::uint32_t material = 0;  ///< index into Scene::materials
  std::string label{};         ///< what words call it; empty: the name
};

/// A group of shapes placed by a transform, traced as an Embree instance. Emitters inside groups are lights like any.
struct Group {
  std::string name{};
  std::vector<Shape> shapes{};
};

struct Instance {
  std::uint32_t group = 0;
  glm::mat4 to_world{1};  ///< affine
};

/// A parallelogram from `corner`; front is the side of cross(edge_u, edge_v); u and v run along the edges.
Mesh make_quad(glm::vec3 corner, glm::vec3 edge_u, glm::vec3 edge_v);
/// A box between two corners; front is outside, or inside when `inward`.
Mesh make_box(glm::vec3 low, glm::vec3 high, bool inward = false);

// ---- lights and eyes ------------------------------------------------------------------------------------------------

/// Isotropic point light; intensity in W sr^-1. Area lights are materials with emission.
struct PointLight {
  glm::vec3 position{0};
  Rgb intensity{1.0f};
  std::string light_group{};  ///< empty: none
};

/// A point light that shines into a cone: full intensity up to `falloff_degrees` from the axis, from there falling
/// linearly with the angle to nothing at `cutoff_degrees` (as Mitsuba's spot does). Letter p, as for a point light.
struct SpotLight {
  glm::vec3 position{0};
  glm::vec3 direction{0, 0, -1};  ///< of the axis, away from the light; of any length
  Rgb intensity{1.0f};            ///< on the axis, W sr^-1
  float cutoff_degrees = 20;      ///< half the opening angle, above 0, at most 180
  float falloff_degrees = 15;     ///< from 0 to cutoff_degrees; equal to it: a hard edge
  std::string light_group{};      ///< empty: none
};

/// Parallel light from infinitely far away, such as the sun's without its disk. Letter d.
struct DistantLight {
  glm::vec3 direction{0, -1, 0};  ///< in which the light travels; of any length
  Rgb irradiance{1.0f};           ///< on a surface that faces it, W m^-2
  std::string light_group{};      ///< empty: none
};

enum class Interpolation : std::uint8_t { Nearest, Bilinear };

/// Radiance from infinitely far away as an equirectangular image, seen from inside with +y up: the left edge lies
/// towards -z, then, to the right, follow +x, +z (in the middle) and -x.
struct EnvironmentImage {
  int width = 0, height = 0;
  std::vector<Rgb> pixels{};  ///< row by row from the top
  glm::mat3 to_world{1};      ///< a rotation, which may mirror too
  Interpolation interpolation = Interpolation::Bilinear;
};

/// How the picture's plane becomes rays.
enum class Projection : std::uint8_t {
  Perspective,   ///< through a point or a lens
  Orthographic,  ///< parallel to the viewing axis
  Panoramic      ///< all directions from a point: longitude across, latitude down, the viewing axis in the middle
};

/// An eye. A perspective one is a pinhole (letter p) when `lens_radius` is zero, a thin lens (letter l) otherwise. The
/// panoramic eye is a point, and the orthographic one a point infinitely far away: both have the letter p.
struct Camera {
  glm::vec3 position{0, 0, 5};
  glm::vec3 look_at{0};
  glm::vec3 up{0, 1, 0};
  float vertical_fov_degrees = 40;  ///< perspective
  float lens_radius = 0;            ///< perspective
  float focus_distance = 1;         ///< distance along the viewing axis that is in focus; read when lens_radius > 0
  Projection projection = Projection::Perspective;
  float height = 2;       ///< orthographic: of the picture, in scene units
  bool mirrored = false;  ///< left and right of the picture change places
};

enum class FilterKind : std::uint8_t { Box, Tent, Gaussian, BlackmanHarris };

/// The weight of a point of the picture for a pixel: one factor by its distance along x from the pixel's centre, one by
/// that along y; nothing from `radius` on. The Gaussian has a standard deviation of a quarter of the radius (filter.h).
struct PixelFilter {
  FilterKind kind = FilterKind::Box;
  float radius = 0.5f;  ///< in pixels
};

/// What the scene's author suggests; flags override each.
struct RenderDefaults {
  std::optional<int> width, height, samples_per_pixel, max_depth;
  std::optional<std::uint64_t> seed;
  std::optional<PixelFilter> filter;
};

struct Scene {
  std::string name{};
  std::string title;  ///< one line for people
  std::vector<Material> materials;
  std::vector<Texture> textures{};
  std::vector<Medium> media{};
  std::optional<std::uint32_t> medium{};  ///< index into media: what fills all space outside of bodies; none: nothing
  std::vector<Shape> shapes{};
  std::vector<Group> groups;
  std::vector<Instance> instances;
  std::vector<PointLight> point_lights;
  std::vector<SpotLight> spot_lights;
  std::vector<DistantLight> distant_lights;
  Rgb environment;                                    ///< constant radiance from every direction; black: none
  std::optional<EnvironmentImage> environment_image;  ///< comes on top of `environment`
  Rgb ambient;                                        ///< I_a of the recursive tracers' ambient term
  Camera camera;
  RenderDefaults defaults;
};

}  // namespace heckbert::transport
