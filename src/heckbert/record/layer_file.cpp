#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <set>

#include <heckbert/record/atomic_file.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/file.h>

namespace heckbert::record {

namespace {

std::string prefix_of(const std::string& layer) {
  return layer.empty() ? "" : layer + ".";
}

/// "<name>.", also for the unnamed layer, so that no attribute of a layer meets one of OpenEXR's own.
std::string attribute_prefix(const std::string& layer) {
  return layer + ".";
}

/// Names of the layers that have all of R, G and B, the unnamed one first.
std::set<std::string> colour_layers(const Imf::ChannelList& channels) {
  std::set<std::string> names;
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    const std::string channel = i.name();
    const std::size_t dot = channel.rfind('.');
    const std::string layer = dot == std::string::npos ? "" : channel.substr(0, dot);
    const auto has = [&](const char* colour) { return channels.findChannel(prefix_of(layer) + colour) != nullptr; };
    if (has("R") && has("G") && has("B")) names.insert(layer);
  }
  return names;
}

std::map<std::string, std::string> attributes_of(const Imf::Header& header, const std::string& layer) {
  const std::string prefix = attribute_prefix(layer);
  std::map<std::string, std::string> attributes;
  for (auto i = header.begin(); i != header.end(); ++i) {
    const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
    const std::string name = i.name();
    if (text != nullptr && name.starts_with(prefix)) attributes[name.substr(prefix.size())] = text->value();
  }
  return attributes;
}

void insert_data(Imf::ChannelList& channels, Imf::FrameBuffer& frame, const DataLayer& layer, const Window& window) {
  constexpr std::array<const char*, 4> kNames{"R", "G", "B", "A"};
  using Pixel = std::array<float, 4>;
  for (std::size_t c = 0; c < kNames.size(); ++c) {
    const std::string name = prefix_of(layer.name) + kNames[c];
    const char* first = reinterpret_cast<const char*>(layer.pixels.data()) + c * sizeof(float);
    channels.insert(name, Imf::Channel(Imf::FLOAT));
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, first, exr::box_of(window), sizeof(Pixel)));
  }
}

/// Layers that Nuke makes itself when it starts.
constexpr std::array<std::string_view, 11> kNamesOfNuke{
    "rgb", "rgba", "alpha", "depth", "mask", "motion", "forward", "backward", "disparity", "disparityl", "disparityr"};

bool is_same_name(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return small(x) == small(y); });
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

void write_layers(const std::vector<Layer>& layers, const RenderInfo& info, const std::filesystem::path& path,
                  const Attachment& attachment) {
  exr::writing(path, [&] {
    Imf::Header header = exr::header_for(info);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    for (const Layer& layer : layers) {
      exr::insert_rgb(header.channels(), prefix_of(layer.name));
      exr::insert_rgb(frame, prefix_of(layer.name), layer.image.pixels.data(), info.window);
      for (const auto& [key, value] : layer.attributes)
        header.insert(attribute_prefix(layer.name) + key, Imf::StringAttribute(value));
    }
    for (const DataLayer& layer : attachment.layers) insert_data(header.channels(), frame, layer, info.window);
    for (const auto& [key, value] : attachment.attributes) header.insert(key, Imf::StringAttribute(value));
    AtomicFile target(path);
    exr::OutputStream stream(target.temporary());
    {
      Imf::OutputFile file(stream, header, exr::threads());
      file.setFrameBuffer(frame);
      file.writePixels(info.window.height());
    }
    stream.close();
    target.commit();
  });
}

std::vector<Layer> read_layers(const std::filesystem::path& path) {
  return exr::reading(path, [&] {
    exr::check_is_exr(path);
    Imf::InputFile file(path.c_str(), exr::threads());
    const Imf::Header& header = file.header();
    if (header.hasType() && !Imf::isImage(header.type()))
      throw std::runtime_error("this is a deep EXR; expected a flat one with channels R, G and B");
    if (!file.isComplete()) throw std::runtime_error("the file is incomplete: scan lines are missing");
    const std::set<std::string> names = colour_layers(header.channels());
    if (names.empty()) throw std::runtime_error("this EXR has no layer with channels R, G and B");

    const Window window = exr::window_of(header.dataWindow());
    std::vector<Layer> layers;
    Imf::FrameBuffer frame;
    for (const std::string& name : names) {
      layers.push_back({name, {window, std::vector<Rgb>(window.pixel_count())}, attributes_of(header, name)});
      exr::insert_rgb(frame, prefix_of(name), layers.back().image.pixels.data(), window);
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.y0, window.y1 - 1);
    return layers;
  });
}

std::string layer_name(std::string_view text, const std::vector<std::string>& taken) {
  std::string name(text);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_name_character(c); }, '_');
  if (name.empty() || (name.front() >= '0' && name.front() <= '9')) name.insert(name.begin(), '_');
  name.resize(std::min(name.size(), kLongestLayerName));
  const std::string stem = name;
  const auto is_free = [&] {
    const auto is_it = [&](std::string_view other) { return is_same_name(name, other); };
    return std::none_of(taken.begin(), taken.end(), is_it) &&
           std::none_of(kNamesOfNuke.begin(), kNamesOfNuke.end(), is_it);
  };
  for (int number = 2; !is_free(); ++number) {
    const std::string suffix = fmt::format("_{}", number);
    name = stem.substr(0, kLongestLayerName - suffix.size()) + suffix;
  }
  return name;
}

}  // namespace heckbert::record
