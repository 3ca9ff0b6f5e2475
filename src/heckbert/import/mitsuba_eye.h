#pragma once
// Mitsuba's sensors, with their film and sampler, and its integrators: from where and how the picture is taken.

#include <heckbert/import/mitsuba_reader.h>

namespace heckbert::import {

/// The scene's camera, and from the film and the sampler its size, filter and samples per pixel.
void read_sensor(MitsubaReader& in, const XmlNode& node);

/// The integrator's path length. Mitsuba counts segments, so its `max_depth` of 1 is what is seen of the lights alone;
/// here scatterings are counted, one less.
void read_integrator(MitsubaReader& in, const XmlNode& node);

std::vector<MitsubaPluginFacts> sensor_facts();
std::vector<MitsubaPluginFacts> filter_facts();
std::vector<MitsubaPluginFacts> integrator_facts();

}  // namespace heckbert::import
