#include <heckbert/cli/traced_paths.h>

#include <algorithm>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include <heckbert/cli/choice.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/cli/settings.h>
#include <heckbert/report/numbers.h>
#include <heckbert/taxonomy/error.h>
#include <heckbert/transport/filter.h>
#include <heckbert/transport/scene_hash.h>

namespace heckbert::cli {
namespace {

using transport::RetracedPath;
using transport::TrailVertex;

/// "gaussian 1.5"
transport::PixelFilter filter_of(const std::string& text) {
  std::istringstream stream(text);
  std::string name;
  transport::PixelFilter filter;
  stream >> name >> filter.radius;
  filter.kind = choose(name, transport::kFilters).kind;
  return filter;
}

std::string_view name_of(record::Technique technique) {
  if (technique.merged) return "stored light";  // of patches; walks from the light are not traced again
  return technique == record::Technique::Hit ? "hit" : "next event";
}

/// The record's words at the pixel and how many paths of each there are must be those of the paths.
void check_same(const std::vector<RetracedPath>& paths, const record::Record& record, int x, int y) {
  std::map<taxonomy::Word, std::uint32_t> counts;
  for (const RetracedPath& path : paths) ++counts[path.word];
  std::map<taxonomy::Word, std::uint32_t> recorded;
  for (const record::Entry& entry : record.pixel(x, y)) recorded[record.words[entry.word]] = entry.count;
  if (counts == recorded) return;
  throw ReadError(fmt::format(
      "the paths that were traced again are not those of the record, which was rendered by heckbert {} on another "
      "machine or with another compiler; render it here to see its paths",
      record.info.version));
}

std::string place(const TrailVertex& vertex) {
  return fmt::format("{:.4f} {:.4f} {:.4f}{}", vertex.position.x, vertex.position.y, vertex.position.z,
                     vertex.is_direction ? " (direction)" : "");
}

std::string colour(Rgb value) {
  return fmt::format("{:.4g} {:.4g} {:.4g}", value.r, value.g, value.b);
}

report::Json to_json(glm::vec3 v) {
  return {v.x, v.y, v.z};
}

report::Json to_json(Rgb value) {
  return {value.r, value.g, value.b};
}

double light_of(const RetracedPath& path) {
  return static_cast<double>(luminance(path.value));
}

}  // namespace

transport::RenderSettings settings_of(const record::RenderInfo& info) {
  if (info.sampler.ends_with(transport::kAdaptive))
    throw ReadError("this record cannot be traced again: it does not say where --adaptive put its samples");
  transport::RenderSettings settings;
  try {
    settings.algorithm = choose(info.algorithm, transport::kAlgorithms).id;
    settings.sampler = choose(info.sampler, transport::kSamplers).kind;
    settings.filter = filter_of(info.filter);
    if (!info.method.empty()) settings.method = parse_method(info.method);
    if (!info.labels.empty()) settings.labels = parse_labels(info.labels);
  } catch (const BadValue& error) {
    throw ReadError(fmt::format("this record cannot be traced again: {}", error.what()));
  }
  if (!info.parts.empty())
    throw ReadError("this record cannot be traced again: it holds samples of several renders, or of a part of one");
  settings.width = info.width;
  settings.height = info.height;
  settings.crop = info.window;
  settings.samples_per_pixel = info.samples_per_pixel;
  settings.max_depth = info.max_depth;
  settings.seed = info.seed;
  return settings;
}

std::vector<RetracedPath> traced_paths(const record::Record& record, const std::string& scene, int x, int y) {
  const transport::RenderSettings settings = settings_of(record.info);
  const std::string& name = scene.empty() ? record.info.scene : scene;
  const import::Imported imported = load_scene(name);
  if (fmt::format("{:016x}", transport::hash_of(imported.scene)) != record.info.scene_hash)
    throw ReadError(fmt::format("'{}' is not the scene of this record: it has changed since, or is another one", name));
  std::vector<RetracedPath> paths = transport::retrace(imported.scene, settings, x, y);
  check_same(paths, record, x, y);
  std::stable_sort(paths.begin(), paths.end(),
                   [](const RetracedPath& a, const RetracedPath& b) { return light_of(a) > light_of(b); });
  return paths;
}

std::string paths_text(const std::vector<RetracedPath>& paths, const record::Record& record,
                       const report::TextStyle& style, std::size_t most) {
  double total = 0;
  for (const RetracedPath& path : paths) total += light_of(path);
  std::string text;
  const std::size_t shown = most == 0 ? paths.size() : std::min(most, paths.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const RetracedPath& path = paths[i];
    text += fmt::format("\n{}  {} of the pixel: {} by {}, sample {}\n", report::bold(plain(path.word), style),
                        report::percent(total > 0 ? light_of(path) / total : 0),
                        colour(path.value / static_cast<float>(record.info.samples_per_pixel)), name_of(path.technique),
                        path.sample);
    const std::vector<taxonomy::Letter> letters = letters_of(path.word);
    std::vector<report::TextRow> rows;
    for (std::size_t v = 0; v < path.vertices.size(); ++v)
      rows.push_back(
          {.cells = {taxonomy::name(letters[v]), place(path.vertices[v]), colour(path.vertices[v].throughput)}});
    text += report::text_table({{"Letter"}, {"Place"}, {"Throughput from the eye"}}, rows, style);
  }
  if (shown < paths.size()) text += fmt::format("\nand {}\n", report::counted(paths.size() - shown, "more path"));
  return text;
}

report::Json to_json(const std::vector<RetracedPath>& paths) {
  report::Json list = report::Json::array();
  for (const RetracedPath& path : paths) {
    report::Json vertices = report::Json::array();
    const std::vector<taxonomy::Letter> letters = letters_of(path.word);
    for (std::size_t v = 0; v < path.vertices.size(); ++v) {
      const TrailVertex& vertex = path.vertices[v];
      vertices.push_back({{"letter", taxonomy::name(letters[v].symbol)},
                          {"label", letters[v].label},
                          {"position", to_json(vertex.position)},
                          {"is_direction", vertex.is_direction},
                          {"throughput", to_json(vertex.throughput)}});
    }
    list.push_back({{"word", fine(path.word)},
                    {"technique", name_of(path.technique)},
                    {"sample", path.sample},
                    {"value", to_json(path.value)},
                    {"vertices", std::move(vertices)}});
  }
  return list;
}

}  // namespace heckbert::cli
