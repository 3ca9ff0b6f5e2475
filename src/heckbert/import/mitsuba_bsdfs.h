#pragma once
// Mitsuba's BSDFs as sums of lobes.

#include <heckbert/import/mitsuba_reader.h>

namespace heckbert::import {

/// The material that a <bsdf> describes. What is not known becomes grey, which is told.
transport::Material read_bsdf(MitsubaReader& in, const XmlNode& node);

std::vector<MitsubaPluginFacts> bsdf_facts();

}  // namespace heckbert::import
