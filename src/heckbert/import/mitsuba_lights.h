#pragma once
// Mitsuba's emitters that are no shapes.

#include <heckbert/import/mitsuba_reader.h>

namespace heckbert::import {

/// Adds an <emitter> of the scene. What is not known is left out, which is told.
void read_light(MitsubaReader& in, const XmlNode& node);

std::vector<MitsubaPluginFacts> light_facts();

}  // namespace heckbert::import
