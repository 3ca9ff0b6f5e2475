#pragma once
// Triangles for Embree, as those benchmarks attach them that trace without heckbert.

#include <algorithm>

#include <embree3/rtcore.h>
#include <glm/glm.hpp>

#include <heckbert/transport/scene.h>

namespace heckbert::bench {

inline void attach_mesh(RTCDevice device, RTCScene scene, const transport::Mesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), mesh.positions.size()));
  std::copy(mesh.positions.begin(), mesh.positions.end(), vertices);
  auto* triangles = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), mesh.triangles.size()));
  std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace heckbert::bench
