#pragma once
// Mitsuba's shapes: geometry, the material on it, and the light that it gives.

#include <heckbert/import/mitsuba_reader.h>

namespace heckbert::import {

/// Adds a <shape> to the scene, as shape, group or instance. What is not known is left out, which is told.
void read_shape(MitsubaReader& in, const XmlNode& node);

std::vector<MitsubaPluginFacts> shape_facts();

}  // namespace heckbert::import
