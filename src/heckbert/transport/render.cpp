#include <heckbert/transport/render.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <heckbert/record/recorder.h>
#include <heckbert/record/sums.h>
#include <heckbert/transport/filter.h>
#include <heckbert/transport/material.h>
#include <heckbert/transport/method_options.h>
#include <heckbert/transport/pass.h>
#include <heckbert/transport/scene_hash.h>
#include <heckbert/transport/stage.h>
#include <heckbert/transport/travel.h>

namespace heckbert::transport {

using record::Window;

namespace {

constexpr int kTileSize = 32;
/// Splats are handed over this often at least, for checkpoints.
constexpr std::chrono::seconds kLongestWait{20};

void check(const Scene& scene, const RenderSettings& settings) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(what);
  };
  constexpr int kLargestSide = 1 << 16;
  require(
      settings.width > 0 && settings.height > 0 && settings.width <= kLargestSide && settings.height <= kLargestSide,
      fmt::format("the picture's size must be 1 to {} pixels a side, not {}x{}", kLargestSide, settings.width,
                  settings.height));
  require(settings.samples_per_pixel > 0,
          fmt::format("samples per pixel must be at least 1, not {}", settings.samples_per_pixel));
  require(1 <= settings.part.number && settings.part.number <= settings.part.of,
          fmt::format("there is no part {0} of {1}; expected 1 to {1}", settings.part.number, settings.part.of));
  require(settings.part.of <= settings.samples_per_pixel,
          fmt::format("{} samples per pixel cannot be shared out into {} parts", settings.samples_per_pixel,
                      settings.part.of));
  require(settings.max_depth >= 0, fmt::format("the maximum depth must not be negative, like {}", settings.max_depth));
  require(settings.threads >= 0, fmt::format("the number of threads must not be negative, like {}", settings.threads));
  require(settings.filter.radius > 0, "the radius of the pixel filter must be above 0");
  const Window w = picture_window(settings);
  require(w.x0 >= 0 && w.y0 >= 0 && w.x0 < w.x1 && w.y0 < w.y1 && w.x1 <= settings.width && w.y1 <= settings.height,
          fmt::format("the crop {},{},{},{} is not inside the {}x{} picture", w.x0, w.y0, w.x1, w.y1, settings.width,
                      settings.height));
  require(!settings.sample_map ||
              (settings.sample_map->window == w && settings.sample_map->repeats.size() == w.pixel_count() &&
               std::ranges::all_of(settings.sample_map->repeats, [](auto n) { return n > 0; })),
          "the sample map must repeat every pixel of the window at least once");
  require(settings.skip.empty() || settings.skip.size() == w.pixel_count(),
          "the pixels to skip must be those of the window");
  const AlgorithmFacts& algorithm = facts(settings.algorithm);
  require(!settings.sample_map || !algorithm.from_light,
          fmt::format("a sample map is for walks from the eye alone; {} has others", algorithm.title));
  require(settings.skip.empty() || !algorithm.passes,
          fmt::format("{} goes over the whole picture for each sample number: it skips no pixels", algorithm.title));
  require(settings.method.photon_radius > 0, "the radius within which photons are near must be above 0");
  require(settings.method.photons_per_pixel > 0 && settings.method.gather_rays > 0,
          "there must be at least one photon, and one ray to gather its light");
  require(!algorithm.patches || settings.labels == LabelRule{},
          "radiosity knows how often light was scattered, but not where: it can label no letters");
  for (const Material& material : scene.materials) check_material(scene, material);
  check_media(scene);
  require(!algorithm.patches || !has_bodies(scene),
          fmt::format("{} takes no scenes with media, index-matched boundaries or materials with an interior",
                      algorithm.title));
}

record::SampleRange samples_of(const RenderSettings& settings) {
  return record::samples_of(settings.part, settings.seed, settings.samples_per_pixel);
}

/// Tiles row by row, so that a picture fills from the top.
std::vector<Window> tiles_of(const Window& window) {
  std::vector<Window> tiles;
  for (int y = window.y0; y < window.y1; y += kTileSize)
    for (int x = window.x0; x < window.x1; x += kTileSize)
      tiles.push_back({x, y, std::min(x + kTileSize, window.x1), std::min(y + kTileSize, window.y1)});
  return tiles;
}

/// Tells the listener how far the render is, not more often than it can be read.
class ProgressMeter {
 public:
  ProgressMeter(const RenderHooks& hooks, std::size_t pixels) : hooks_(hooks), pixels_(pixels) {}

  void advance(std::size_t pixels, std::uint64_t rays) {
    if (!hooks_.progress) return;
    const std::scoped_lock lock(mutex_);
    done_ += pixels;
    rays_ += rays;
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(200) && done_ < pixels_) return;
    last_ = now;
    hooks_.progress({.fraction = static_cast<double>(done_) / static_cast<double>(pixels_),
                     .rays = rays_,
                     .seconds = std::chrono::duration<double>(now - start_).count()});
  }

 private:
  const RenderHooks& hooks_;
  const std::size_t pixels_;
  std::mutex mutex_;
  std::size_t done_ = 0;
  std::uint64_t rays_ = 0;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
};

/// What is the same for all tiles, passes and threads of a render.
struct Job {
  const RenderSettings& settings;
  const RenderHooks& hooks;
  bool wants_words;
  Window window;
  std::vector<Window> tiles;

  bool skips(int x, int y) const {
    return !settings.skip.empty() &&
           settings.skip[static_cast<std::size_t>(y - window.y0) * static_cast<std::size_t>(window.width()) +
                         static_cast<std::size_t>(x - window.x0)];
  }
  bool is_stopped() const { return hooks.stop != nullptr && hooks.stop->load(std::memory_order_relaxed); }
  /// A repeated sample is as good as one of another render.
  SamplePlan plan(int repeat) const {
    constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;
    return {settings.sampler, settings.seed ^ (static_cast<std::uint64_t>(repeat) * kGoldenRatio),
            settings.samples_per_pixel};
  }
};

/// Gives back how many rays it took. `found` is emptied.
std::uint64_t trace_sample(const Job& job, const World& world, record::PathSink& sink,
                           std::vector<record::Contribution>& found, const SamplePlan& plan, int x, int y, int sample) {
  Walk walk{.sink = sink,
            .found = found,
            .sampler = Sampler(plan, x, y, sample),
            .wants_words = job.wants_words,
            .bodies = world.bodies_at_eye};
  sink.begin_sample(x, y, sample);
  found.clear();
  trace(world, walk, x, y, job.settings.algorithm);
  sink.add(found);
  if (!is_black(walk.cut_off)) sink.add_cut_off(walk.cut_off);
  return walk.rays;
}

struct Done {
  std::size_t pixels = 0;
  std::uint64_t rays = 0;
};

/// The samples of these numbers, of all pixels of a tile until the render is stopped.
template <class Worker>
Done trace_tile(const Job& job, const World& world, Worker& worker, std::vector<record::Contribution>& found,
                const Window& tile, record::SampleRange samples) {
  Done done;
  worker.begin(tile);
  for (int y = tile.y0; y < tile.y1; ++y)
    for (int x = tile.x0; x < tile.x1 && !job.is_stopped(); ++x) {
      if (job.skips(x, y)) continue;
      ++done.pixels;
      const int repeats = job.settings.sample_map ? job.settings.sample_map->at(x, y) : 1;
      for (int repeat = 0; repeat < repeats; ++repeat) {
        const SamplePlan plan = job.plan(repeat);
        for (int sample = samples.first; sample < samples.last; ++sample)
          done.rays += trace_sample(job, world, worker.sink(), found, plan, x, y, sample);
      }
      if (worker.is_due()) {
        worker.end();
        worker.begin(tile);
      }
    }
  worker.end();
  return done;
}

/// Traces every tile of the picture, once or in passes. `make_worker()` is called once per thread; a worker has sink(),
/// begin(tile) and end() for each tile, is_due() where a tile had better end, its rest being another one, and finish()
/// for the end of its work. Gives back whether the whole picture was done.
template <class MakeWorker>
bool trace_tiles(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks, bool wants_words,
                 MakeWorker make_worker) {
  const int threads =
      settings.threads > 0 ? settings.threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  const Stage stage(scene, settings);
  const Window window = picture_window(settings);
  const Job job{settings, hooks, wants_words, window, tiles_of(window)};

  std::deque<decltype(make_worker())> workers;
  for (int i = 0; i < threads; ++i) {
    workers.push_back(make_worker());
    stage.world().labels.number_in(workers.back().sink().words());
  }

  // All samples in one pass, or one pass for each sample number.
  const record::SampleRange samples = samples_of(settings);
  const bool by_passes = facts(settings.algorithm).passes;
  const std::size_t pixels_per_pass =
      window.pixel_count() - static_cast<std::size_t>(std::ranges::count(settings.skip, true));
  const std::size_t pixel_count = pixels_per_pass * static_cast<std::size_t>(by_passes ? samples.count() : 1);
  ProgressMeter meter(hooks, pixel_count);
  std::atomic<std::size_t> pixels_done{0};

  const auto trace_pass = [&](const World& world, record::SampleRange numbers) {
    std::atomic<std::size_t> next_tile{0};
    tbb::parallel_for(
        std::size_t{0}, workers.size(),
        [&](std::size_t thread) {
          auto& worker = workers[thread];
          std::vector<record::Contribution> found;
          for (std::size_t number; !job.is_stopped() && (number = next_tile++) < job.tiles.size();) {
            const Done done = trace_tile(job, world, worker, found, job.tiles[number], numbers);
            pixels_done += done.pixels;
            meter.advance(done.pixels, done.rays);
          }
        },
        tbb::simple_partitioner());
  };
  tbb::task_arena arena(threads);
  arena.execute([&] {
    if (!by_passes) return trace_pass(stage.world(), samples);
    for (int sample = samples.first; sample < samples.last && !job.is_stopped(); ++sample) {
      const Pass pass(stage.world(), settings, job.plan(0), sample);
      trace_pass(pass.world(), {.first = sample, .last = sample + 1});
    }
  });
  for (auto& worker : workers) worker.finish();
  return pixels_done == pixel_count;
}

/// Adds everything up to one colour per pixel and forgets the rest.
class PictureSink final : public record::PathSink {
 public:
  explicit PictureSink(record::Image& image) : image_(image) {}
  void begin_sample(int x, int y, int) override {
    const Window& w = image_.window;
    pixel_ = &image_.pixels[static_cast<std::size_t>(y - w.y0) * static_cast<std::size_t>(w.width()) +
                            static_cast<std::size_t>(x - w.x0)];
  }
  void add(const record::Contribution& contribution) override { *pixel_ += contribution.value; }
  void add(std::span<const record::Contribution> contributions) override {
    for (const record::Contribution& contribution : contributions) *pixel_ += contribution.value;
  }
  void add_non_path(record::NonPath, Rgb) override {}
  void end_path(record::PathEnd) override {}

 private:
  record::Image& image_;
  Rgb* pixel_ = nullptr;
};

}  // namespace

record::RenderInfo info_of(const Scene& scene, const RenderSettings& settings) {
  const auto& filter = kFilters[static_cast<std::size_t>(settings.filter.kind)];
  record::RenderInfo info{
      .scene = scene.name,
      .scene_hash = fmt::format("{:016x}", hash_of(scene)),
      .algorithm = std::string(facts(settings.algorithm).name),
      .method = write(settings.method),
      .sampler = fmt::format("{}{}", kSamplers[static_cast<std::size_t>(settings.sampler)].name,
                             settings.sample_map ? kAdaptive : ""),
      .filter = fmt::format("{} {}", filter.name, settings.filter.radius),
      .width = settings.width,
      .height = settings.height,
      .window = picture_window(settings),
      .knows_cut_off = !facts(settings.algorithm).from_light,
      .max_depth = settings.max_depth,
      .labels = write(settings.labels),
      .version = HECKBERT_VERSION,
  };
  set_samples(info, {samples_of(settings)});
  return info;
}

bool render_tiles(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks,
                  const std::function<void(record::Tile)>& take) {
  check(scene, settings);
  const record::RenderInfo info = info_of(scene, settings);
  std::mutex mutex;
  /// Where walks splat, finished tiles wait for the splats that were made with them, and all go together, so that what
  /// was handed over is always what some number of whole samples found.
  struct Worker {
    using Clock = std::chrono::steady_clock;
    record::TileRecorder recorder;
    const std::function<void(record::Tile)>& take;
    const RenderHooks& hooks;
    std::mutex& mutex;
    bool splats;
    std::vector<record::Tile> waiting{};
    std::size_t waiting_bytes = 0;
    Clock::time_point last = Clock::now();

    record::PathSink& sink() { return recorder; }
    void begin(const Window& tile) { recorder.begin_tile(tile); }
    bool is_due() const {
      return splats && (waiting_bytes + recorder.splat_bytes() > kSplatBytes || Clock::now() - last >= kLongestWait);
    }
    void end() {
      waiting.push_back(recorder.end_tile());
      waiting_bytes += waiting.back().entries.size() * sizeof(record::EntrySum);
      if (!splats || is_due()) finish();
    }
    void finish() {
      if (waiting.empty()) return;
      if (splats) recorder.sort_splats();
      const std::scoped_lock lock(mutex);
      for (record::Tile& tile : waiting) take(std::move(tile));
      if (splats) take(recorder.end_splats());
      if (hooks.settled) hooks.settled();
      waiting.clear();
      waiting_bytes = 0;
      last = Clock::now();
    }
  };
  return trace_tiles(scene, settings, hooks, true, [&] {
    return Worker{.recorder = record::TileRecorder(info, settings.sample_map ? &*settings.sample_map : nullptr),
                  .take = take,
                  .hooks = hooks,
                  .mutex = mutex,
                  .splats = facts(settings.algorithm).splats};
  });
}

record::Record render(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks) {
  check(scene, settings);
  if (facts(settings.algorithm).from_light) {
    // Tiles that overlap take more memory apart than together.
    constexpr std::size_t kMostPictures = 8;
    const Window window = picture_window(settings);
    std::vector<record::Tile> tiles;
    std::size_t pixels = 0;  // of all of these
    const auto add_up = [&] { return record::added(window, std::exchange(tiles, {})); };
    const bool complete = render_tiles(scene, settings, hooks, [&](record::Tile tile) {
      pixels += tile.window.pixel_count();
      tiles.push_back(std::move(tile));
      if (pixels <= kMostPictures * window.pixel_count()) return;
      tiles = {add_up()};
      pixels = window.pixel_count();
    });
    record::Sums sums{info_of(scene, settings), add_up()};
    sums.info.partial = !complete;
    return record::record_of(std::move(sums));
  }
  record::Assembler assembler(info_of(scene, settings));
  const bool complete =
      render_tiles(scene, settings, hooks, [&](record::Tile tile) { assembler.submit(std::move(tile)); });
  return assembler.finish(!complete);
}

record::TechniqueTable measure_techniques(const Scene& scene, const RenderSettings& settings,
                                          const RenderHooks& hooks) {
  check(scene, settings);
  const record::RenderInfo info = info_of(scene, settings);
  record::TechniqueTable table;
  std::mutex mutex;
  struct Worker {
    record::TechniqueRecorder recorder;
    record::TechniqueTable& table;
    std::mutex& mutex;
    record::PathSink& sink() { return recorder; }
    void begin(const Window&) {}
    static bool is_due() { return false; }
    void end() {}
    void finish() {
      const std::scoped_lock lock(mutex);
      table = record::added(table, recorder.table());
    }
  };
  trace_tiles(scene, settings, hooks, true, [&] { return Worker{record::TechniqueRecorder(info), table, mutex}; });
  return table;
}

record::Image render_picture_only(const Scene& scene, const RenderSettings& settings, const RenderHooks& hooks) {
  check(scene, settings);
  if (settings.sample_map) throw std::invalid_argument("a picture alone takes no sample map");
  if (facts(settings.algorithm).splats) throw std::invalid_argument("a picture alone takes no splats");
  const Window window = picture_window(settings);
  record::Image image{window, std::vector<Rgb>(window.pixel_count())};
  struct Worker {
    PictureSink picture;
    record::PathSink& sink() { return picture; }
    void begin(const Window&) {}
    static bool is_due() { return false; }
    void end() {}
    void finish() {}
  };
  trace_tiles(scene, settings, hooks, false, [&] { return Worker{PictureSink(image)}; });
  for (Rgb& pixel : image.pixels) pixel *= 1.0f / static_cast<float>(samples_of(settings).count());
  return image;
}

}  // namespace heckbert::transport
