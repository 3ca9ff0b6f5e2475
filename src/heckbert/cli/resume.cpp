#include <heckbert/cli/resume.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <heckbert/cli/files.h>
#include <heckbert/taxonomy/error.h>

namespace heckbert::cli {
namespace {

std::string samples_text(const record::RenderInfo& info) {
  std::vector<std::string> ranges;
  for (const record::SampleRange& range : record::samples_of(info)) ranges.push_back(record::to_text(range));
  return fmt::format("{}", fmt::join(ranges, ", "));
}

}  // namespace

record::SumsStream resumed(const std::string& name, const record::RenderInfo& wanted) {
  record::SumsStream begun = open_sums(name);
  const auto refuse = [&](const std::string& why) {
    throw ReadError(fmt::format("cannot resume '{}' with these settings: {}", name, why));
  };
  try {
    record::check_alike(begun.info, wanted);
  } catch (const record::MergeError& error) {
    refuse(error.what());
  }
  if (const std::string there = samples_text(begun.info), here = samples_text(wanted); there != here)
    refuse(fmt::format("the samples differ: '{}' and '{}'", there, here));
  const auto all = static_cast<std::uint32_t>(wanted.samples_per_pixel);
  if (std::ranges::any_of(begun.totals.samples, [&](std::uint32_t taken) { return taken != 0 && taken != all; }))
    refuse("it was merged from parts that were not whole; resume those parts and merge again");
  rows_of(begun)([](const record::PixelRow&) {});
  return begun;
}

std::vector<bool> pixels_done(const record::SumsStream& begun) {
  std::vector<bool> done;
  done.reserve(begun.totals.samples.size());
  for (const std::uint32_t taken : begun.totals.samples) done.push_back(taken > 0);
  return done;
}

}  // namespace heckbert::cli
