// What a record takes on disk and in memory: renders the lecture's scene into temporary files, tile by tile, in either
// precision, and reads them back; also what OpenEXR alone takes to read the same pixels, unchecked and into its own
// types.
//
// Usage: record_file [SAMPLES_PER_PIXEL [WIDTH [HEIGHT]]]     defaults 64 512 512

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineInputFile.h>
#include <OpenEXR/ImfHeader.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include <heckbert/import/import.h>
#include <heckbert/record/file.h>
#include <heckbert/record/record_spool.h>
#include <heckbert/record/tile_pictures.h>
#include <heckbert/transport/render.h>

namespace {

using namespace heckbert;

/// The least of some runs: what else goes on can only add to it.
template <class F>
double seconds(int runs, F f) {
  double least = 1e30;
  for (int run = 0; run < runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    f();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return least;
}

/// Of this process so far, in MB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// Reads all channels of the first part.
void read_plainly(const std::filesystem::path& path) {
  Imf::DeepScanLineInputFile file(path.c_str());
  const Imath::Box2i box = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(box.max.x + 1);
  std::vector<unsigned> counts(width * static_cast<std::size_t>(box.max.y + 1));
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(
      {Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned), sizeof(unsigned) * width});
  std::vector<std::vector<char*>> pointers;
  std::vector<std::size_t> sizes;
  const Imf::ChannelList& channels = file.header().channels();
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    sizes.push_back(i.channel().type == Imf::HALF ? 2 : 4);
    std::vector<char*>& first = pointers.emplace_back(counts.size());
    frame.insert(i.name(), {i.channel().type, reinterpret_cast<char*>(first.data()), sizeof(char*),
                            sizeof(char*) * width, sizes.back()});
  }
  file.setFrameBuffer(frame);
  file.readPixelSampleCounts(box.min.y, box.max.y);
  const std::size_t total = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  std::vector<std::vector<char>> values;
  for (std::size_t c = 0; c < pointers.size(); ++c) {
    char* next = values.emplace_back(total * sizes[c]).data();
    for (std::size_t i = 0; i < counts.size(); next += counts[i++] * sizes[c]) pointers[c][i] = next;
  }
  file.readPixels(box.min.y, box.max.y);
}

}  // namespace

int main(int argc, char** argv) {
  const int samples = argc > 1 ? std::atoi(argv[1]) : 64;
  const int width = argc > 2 ? std::atoi(argv[2]) : 512;
  const int height = argc > 3 ? std::atoi(argv[3]) : width;
  if (samples < 1 || width < 1 || height < 1) {
    fmt::print(stderr, "usage: record_file [SAMPLES_PER_PIXEL [WIDTH [HEIGHT]]]\n");
    return 2;
  }
  const transport::Scene scene = import::load_scene_or_builtin("lecture").scene;
  const transport::RenderSettings settings{.width = width, .height = height, .samples_per_pixel = samples};
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  const record::RenderInfo info = transport::info_of(scene, settings);
  record::RecordSpool spool(info, folder / "heckbert");
  record::TilePictures pictures(info, {}, taxonomy::GlossyRule::Keep);
  transport::render_tiles(scene, settings, {}, [&](record::Tile tile) {
    pictures.add(tile);
    spool.submit(std::move(tile));
  });
  const record::SumsStream sums = spool.stream();
  fmt::print("lecture {}x{}, {} samples: {} words; peak memory {:.0f} MB while tracing\n", width, height, samples,
             sums.totals.words.size(), peak_memory());
  for (const auto& [precision, name, meaning] : record::kPrecisions) {
    const std::filesystem::path file = folder / fmt::format("heckbert-{}.paths.exr", name);
    const double writing =
        seconds(1, [&, p = precision] { record::write_record(record::totals_of(sums, p), sums, file); });
    fmt::print("{}: {:.1f} MB on disk, written in {:.2f} s, peak memory {:.0f} MB\n", name,
               static_cast<double>(std::filesystem::file_size(file)) / 1e6, writing, peak_memory());
  }
  for (const char* name : {"half", "float"}) {
    const std::filesystem::path file = folder / fmt::format("heckbert-{}.paths.exr", name);
    fmt::print("{}: read in {:.3f} s, without pixels in {:.3f} s; OpenEXR alone {:.3f} s\n", name,
               seconds(3, [&] { record::read_record(file); }), seconds(3, [&] { record::read_record_totals(file); }),
               seconds(3, [&] { read_plainly(file); }));
    std::filesystem::remove(file);
  }
}
