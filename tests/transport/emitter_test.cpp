// Pieces of area lights by themselves: the points drawn follow the density that is asked for separately, and the
// density is one over the solid angle that the piece covers, by quadrature over its surface.

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <heckbert/transport/emitter.h>
#include <heckbert/transport/frame.h>
#include <heckbert/transport/sampler.h>
#include <heckbert/transport/spherical_rectangle.h>
#include <heckbert/transport/spherical_triangle.h>

#include "chi_square.h"

namespace heckbert::transport {
namespace {

/// A piece with a map from the unit square onto its surface, written here once more.
struct Piece {
  const char* name;
  Emitter emitter;
  struct Point {
    glm::dvec3 position, normal;
    double area;  ///< of the surface per area of the unit square
  };
  std::function<Point(double, double)> at;
  std::function<glm::dvec2(glm::dvec3)> place_of;  ///< back to the unit square
};

Piece triangle_piece() {
  const glm::dvec3 p0(-0.7, 0.2, 0.1), e1(1.5, 0.1, -0.3), e2(0.4, 1.1, 0.5);
  const Emitter e = triangle_emitter({glm::vec3(p0), glm::vec3(p0 + e1), glm::vec3(p0 + e2)});
  const glm::dvec3 n = glm::cross(e1, e2);
  const double area = 0.5 * glm::length(n);
  return {"triangle", e,
          [=](double s, double t) {
            return Piece::Point{p0 + s * ((1 - t) * e1 + t * e2), glm::normalize(n), 2 * area * s};
          },
          [=](glm::dvec3 p) {
            const glm::dvec3 d = p - p0;
            const double b1 = glm::dot(glm::cross(d, e2), n) / glm::dot(n, n);
            const double b2 = glm::dot(glm::cross(e1, d), n) / glm::dot(n, n);
            return glm::dvec2(b1 + b2, b2 / (b1 + b2));
          }};
}

Piece rectangle_piece() {
  const glm::dvec3 p0(-0.5, -0.4, 0.2), u(1.2, 0.3, 0.0), v(-0.2, 0.8, 0.4);
  const Emitter e = *rectangle_emitter({glm::vec3(p0), glm::vec3(p0 + u), glm::vec3(p0 + u + v)},
                                       {glm::vec3(p0), glm::vec3(p0 + u + v), glm::vec3(p0 + v)});
  const glm::dvec3 n = glm::cross(u, v);
  return {"rectangle", e,
          [=](double s, double t) {
            return Piece::Point{p0 + s * u + t * v, glm::normalize(n), glm::length(n)};
          },
          [=](glm::dvec3 p) {
            return glm::dvec2(glm::dot(p - p0, u) / glm::dot(u, u), glm::dot(p - p0, v) / glm::dot(v, v));
          }};
}

Piece disk_piece() {
  const glm::dvec3 center(0.2, 0.1, -0.3), n = glm::normalize(glm::dvec3(1, 2, -1)),
                                           s = glm::normalize(glm::dvec3(2, -1, 0)), t = glm::cross(n, s);
  constexpr double kRadius = 0.8;
  return {"disk", disk_emitter(glm::vec3(center), glm::vec3(3.0 * n), static_cast<float>(kRadius)),
          [=](double r, double phi) {
            const double a = 2 * std::numbers::pi * phi;
            return Piece::Point{center + kRadius * r * (std::cos(a) * s + std::sin(a) * t), n,
                                kRadius * kRadius * r * 2 * std::numbers::pi};
          },
          [=](glm::dvec3 p) {
            const double phi = std::atan2(glm::dot(p - center, t), glm::dot(p - center, s)) / (2 * std::numbers::pi);
            return glm::dvec2(glm::length(p - center) / kRadius, phi < 0 ? phi + 1 : phi);
          }};
}

Piece sphere_piece() {
  const glm::dvec3 center(0.1, -0.2, 0.3);
  constexpr double kRadius = 0.6;
  return {"sphere", sphere_emitter(glm::vec3(center), static_cast<float>(kRadius)),
          [=](double s, double phi) {
            const double z = 1 - 2 * s, r = std::sqrt(1 - z * z), a = 2 * std::numbers::pi * phi;
            const glm::dvec3 n(r * std::cos(a), r * std::sin(a), z);
            return Piece::Point{center + kRadius * n, n, 4 * std::numbers::pi * kRadius * kRadius};
          },
          [=](glm::dvec3 p) {
            const glm::dvec3 n = (p - center) / kRadius;
            const double phi = std::atan2(n.y, n.x) / (2 * std::numbers::pi);
            return glm::dvec2((1 - n.z) / 2, phi < 0 ? phi + 1 : phi);
          }};
}

/// Close by, in the middle, far, at a grazing angle; inside the sphere too.
const std::vector<glm::vec3> kPlaces{
    {0.1f, 0.3f, 0.9f}, {0.2f, -1.6f, 1.2f}, {5, 4, 9}, {3.0f, 0.2f, 0.6f}, {0.2f, 0, 0.3f}};

std::vector<Piece> pieces() {
  return {triangle_piece(), rectangle_piece(), disk_piece(), sphere_piece()};
}

/// A sphere hides its own far side, unless one is inside.
bool is_visible(const Piece& piece, const Piece::Point& p, glm::dvec3 from) {
  const glm::dvec3 d = from - glm::dvec3(piece.emitter.center);
  return piece.emitter.form != Emitter::Form::Sphere || glm::length(d) < static_cast<double>(piece.emitter.radius) ||
         glm::dot(p.normal, from - p.position) > 0;
}

double solid_angle_per_area(const Piece::Point& p, glm::dvec3 from) {
  const glm::dvec3 d = p.position - from;
  return std::abs(glm::dot(d, p.normal)) / std::pow(glm::dot(d, d), 1.5);
}

TEST(Emitter, SamplesFollowTheirDensityAndItIsNormalised) {
  // 12 x 12 cells, 100 000 draws, twenty cases at 1 % together after Sidak: 3.3 standard deviations of a normal
  // variable, 4.2 with the skew of chi-square with 143 degrees of freedom.
  constexpr int kCells = 12, kSub = 40, kDraws = 100'000;
  for (const Piece& piece : pieces())
    for (const glm::vec3 from : kPlaces) {
      SCOPED_TRACE(std::string(piece.name) + " from " + std::to_string(from.x));
      std::vector<double> expected(kCells * kCells), seen(kCells * kCells);
      double whole = 0;
      for (int i = 0; i < kCells * kSub; ++i)
        for (int j = 0; j < kCells * kSub; ++j) {
          const Piece::Point p = piece.at((i + 0.5) / (kCells * kSub), (j + 0.5) / (kCells * kSub));
          if (!is_visible(piece, p, from)) continue;
          const double density = pdf_solid_angle(piece.emitter, from, glm::vec3(p.position), glm::vec3(p.normal)) *
                                 solid_angle_per_area(p, from) * p.area / (kCells * kSub * kCells * kSub);
          expected[static_cast<std::size_t>(i / kSub * kCells + j / kSub)] += density * kDraws;
          whole += density;
        }
      EXPECT_NEAR(whole, 1.0, 2e-3);
      for (int n = 0; n < kDraws; ++n) {
        const auto s = sample_surface(piece.emitter, from, Sampler(3, n, 0, 0).next2());
        ASSERT_GT(s.pdf_solid_angle, 0);
        const glm::dvec2 place = piece.place_of(glm::dvec3(s.position)) * double{kCells};
        const auto cell = [](double x) { return std::clamp(static_cast<int>(x), 0, kCells - 1); };
        ++seen[static_cast<std::size_t>(cell(place.x) * kCells + cell(place.y))];
        ASSERT_NEAR(pdf_solid_angle(piece.emitter, from, s.position, s.normal) / s.pdf_solid_angle, 1, 1e-3);
      }
      EXPECT_LT(chi_square_excess(expected, seen), 4.2);
    }
}

TEST(Emitter, RectanglesFromAfarAreDrawnNearlyByTheirSolidAngle) {
  // By solid angle every draw finds the same amount of light where the light's direction does not matter; by area alone
  // the squared deviation at two extents is 0.2 of the squared mean, averaged over all directions
  // (docs/performance.md).
  constexpr int kPlacesAround = 200, kDraws = 200;
  const Piece piece = rectangle_piece();
  const Emitter& e = piece.emitter;
  for (const auto& [extents, most] : {std::pair{2.05f, 0.045}, std::pair{3.0f, 0.012}, std::pair{5.0f, 0.0016}}) {
    SCOPED_TRACE(extents);
    double warped = 0, by_area = 0;
    for (int k = 0; k < kPlacesAround; ++k) {
      const glm::vec3 from = e.center + extents * e.extent * uniform_sphere(Sampler(5, k, 0, 0).next2());
      const auto deviation = [&](const auto& found_by) {
        double sum = 0, sum2 = 0;
        for (int n = 0; n < kDraws; ++n) {
          const double found = found_by(Sampler(6, k, n, 0).next2());
          sum += found;
          sum2 += found * found;
        }
        return sum2 * kDraws / (sum * sum) - 1;
      };
      warped +=
          deviation([&](glm::vec2 u) { return 1 / static_cast<double>(sample_surface(e, from, u).pdf_solid_angle); });
      by_area += deviation([&](glm::vec2 u) {
        const SurfaceSample s = sample_area(e, u);
        return solid_angle_per_area({glm::dvec3(s.position), glm::dvec3(s.normal), 0}, glm::dvec3(from));
      });
    }
    EXPECT_LT(warped / kPlacesAround, most);
    EXPECT_GT(by_area / kPlacesAround, 4 * most) << "the bound would say nothing";
  }
}

TEST(SphericalShapes, HaveTheSolidAnglesOfAnOctantAndOfACubesFace) {
  const SphericalTriangle octant({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, glm::normalize(glm::vec3(1)), {0, 0, 0});
  EXPECT_NEAR(octant.solid_angle(), std::numbers::pi / 2, 1e-7);
  for (const float z : {1.0f, -1.0f}) {
    const Rectangle face({-1, -1, z}, {2, 0, 0}, {0, 2, 0});
    EXPECT_NEAR(SphericalRectangle(face, {0, 0, 0}).solid_angle(), 4 * std::numbers::pi / 6, 1e-12);
  }
  const Rectangle floor({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  EXPECT_EQ(SphericalRectangle(floor, {3, 0, 0}).solid_angle(), 0.0);
  EXPECT_NEAR(SphericalRectangle(floor, {0.5f, 0, 1e-6f}).solid_angle(), 2 * std::numbers::pi, 1e-5);
  EXPECT_EQ(SphericalTriangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, {3, 0, 0}).solid_angle(), 0.0);
}

TEST(SphericalShapes, AreDrawnToTheirCornersFromAFarSide) {
  // From beyond one corner and close to the plane, where the formulas are at their weakest.
  const glm::vec3 from(1.4f, 1.3f, 0.02f);
  const Rectangle square({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const SphericalRectangle rectangle(square, from);
  const SphericalTriangle triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, from);
  for (const float u : {0.0f, 0.5f, 0.99999994f})
    for (const float v : {0.0f, 0.5f, 0.99999994f}) {
      for (const glm::vec3 p : {rectangle.sample({u, v}), triangle.sample({u, v})}) {
        EXPECT_NEAR(p.z, 0.0f, 1e-6f);
        EXPECT_GE(std::min(p.x, p.y), -1e-5f) << u << " " << v;
        EXPECT_LE(std::max(p.x, p.y), 1 + 1e-5f) << u << " " << v;
      }
      EXPECT_LE(triangle.sample({u, v}).x + triangle.sample({u, v}).y, 1 + 1e-5f);
    }
}

TEST(Rectangle, IsFoundInTwoTrianglesWhicheverCornersTheyBeginWith) {
  const std::array<glm::vec3, 4> p{{{1, 2, 3}, {3, 2, 3}, {3, 2, 2}, {1, 2, 2}}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::array<std::size_t, 3> first{0, 1, 2}, second{0, 2, 3};
      const Corners a{p[first[i]], p[first[(i + 1) % 3]], p[first[(i + 2) % 3]]};
      const Corners b{p[second[j]], p[second[(j + 1) % 3]], p[second[(j + 2) % 3]]};
      const auto e = rectangle_emitter(a, b);
      ASSERT_TRUE(e) << i << j;
      EXPECT_FLOAT_EQ(e->area, 2);
      EXPECT_EQ(e->normal, glm::vec3(0, 1, 0));
      EXPECT_EQ(e->center, glm::vec3(2, 2, 2.5f));
    }
  EXPECT_FALSE(rectangle_emitter({p[0], p[1], p[2]}, {p[0], p[3], p[2]})) << "the second faces the other way";
  EXPECT_FALSE(rectangle_emitter({p[0], p[1], p[2]}, {p[0], p[2], p[3] + glm::vec3(0.1f, 0, 0)})) << "no parallelogram";
  const glm::vec3 skew(0.5f, 0, 0);
  EXPECT_FALSE(rectangle_emitter({p[0], p[1], p[2] + skew}, {p[0], p[2] + skew, p[3] + skew})) << "not at right angles";
  EXPECT_FALSE(rectangle_emitter({p[0], p[1], p[2]}, {p[1], p[2], {4, 2, 4}})) << "another edge";
}

}  // namespace
}  // namespace heckbert::transport
