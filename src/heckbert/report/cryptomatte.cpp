#include <heckbert/report/cryptomatte.h>

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include <heckbert/report/json_parts.h>

namespace heckbert::report {
namespace {

constexpr std::size_t kRanksPerLayer = 2;
constexpr std::size_t kLayers = kCryptomatteRanks / kRanksPerLayer;

std::uint32_t id_bits(std::string_view name) {
  constexpr std::uint32_t kExponent = 0xff;
  const std::uint32_t bits = murmur3(name);
  const std::uint32_t exponent = bits >> 23 & kExponent;
  return exponent == 0 || exponent == kExponent ? bits ^ std::uint32_t{1} << 23 : bits;
}

std::string manifest_of(const std::vector<std::string>& names) {
  Json manifest = Json::object();
  for (const std::string& name : names) manifest[name] = fmt::format("{:08x}", id_bits(name));
  return manifest.dump(-1, ' ', true, Json::error_handler_t::replace);
}

struct Ranked {
  std::size_t item;
  double energy;
};

}  // namespace

record::Attachment cryptomatte(const record::Window& window, const record::Rows& rows, const PathClasses& classes,
                               std::string_view name) {
  record::Attachment result;
  const std::string key = fmt::format("cryptomatte/{:.7}/", fmt::format("{:08x}", murmur3(name)));
  result.attributes = {{key + "name", std::string(name)},
                       {key + "hash", "MurmurHash3_32"},
                       {key + "conversion", "uint32_to_float32"},
                       {key + "manifest", manifest_of(classes.names)}};
  for (std::size_t layer = 0; layer < kLayers; ++layer)
    result.layers.push_back(
        {fmt::format("{}{:02}", name, layer), std::vector<std::array<float, 4>>(window.pixel_count())});

  std::vector<float> ids;
  for (const std::string& item : classes.names) ids.push_back(cryptomatte_id(item));
  rows([&](const record::PixelRow& row) {
    std::vector<double> energy(classes.names.size());
    std::vector<Ranked> ranks;
    for (std::size_t x = 0; x < row.pixel_count(); ++x) {
      double total = 0;
      ranks.clear();
      for (const record::Entry& entry : row.pixel(x)) {
        const auto light = static_cast<double>(luminance(entry.energy));
        if (!(light > 0)) continue;
        total += light;
        const std::size_t item = classes.of_word[entry.word];
        if (item == PathClasses::kNone) continue;
        if (energy[item] == 0) ranks.push_back({item, 0});
        energy[item] += light;
      }
      for (Ranked& ranked : ranks) {
        ranked.energy = energy[ranked.item];
        energy[ranked.item] = 0;
      }
      std::sort(ranks.begin(), ranks.end(), [](const Ranked& a, const Ranked& b) {
        return a.energy != b.energy ? a.energy > b.energy : a.item < b.item;
      });
      for (std::size_t rank = 0; rank < std::min(ranks.size(), kCryptomatteRanks); ++rank) {
        std::array<float, 4>& at = result.layers[rank / kRanksPerLayer].pixels[row.first_pixel + x];
        at[2 * (rank % kRanksPerLayer)] = ids[ranks[rank].item];
        at[2 * (rank % kRanksPerLayer) + 1] = static_cast<float>(ranks[rank].energy / total);
      }
    }
  });
  return result;
}

PathClasses classes_by_word(const record::Record& record) {
  PathClasses classes;
  std::unordered_map<std::string, std::size_t> known;
  for (const taxonomy::Word& word : record.words) {
    const auto [place, is_new] = known.try_emplace(plain(word), classes.names.size());
    if (is_new) classes.names.push_back(place->first);
    classes.of_word.push_back(place->second);
  }
  return classes;
}

PathClasses classes_by_set(std::vector<std::string> names, const std::vector<std::vector<bool>>& sets) {
  PathClasses classes{std::move(names), {}};
  if (!sets.empty()) classes.of_word.assign(sets.front().size(), PathClasses::kNone);
  for (std::size_t item = sets.size(); item-- > 0;)
    for (std::size_t word = 0; word < classes.of_word.size(); ++word)
      if (sets[item][word]) classes.of_word[word] = item;
  return classes;
}

std::uint32_t murmur3(std::string_view text) {
  std::uint32_t hash = 0;
  const auto scramble = [](std::uint32_t block) { return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u; };
  const auto block_at = [&](std::size_t at, std::size_t bytes) {
    std::uint32_t block = 0;
    for (std::size_t i = 0; i < bytes; ++i) block |= std::uint32_t{static_cast<unsigned char>(text[at + i])} << 8 * i;
    return block;
  };
  const std::size_t whole = text.size() / 4 * 4;
  for (std::size_t at = 0; at < whole; at += 4)
    hash = std::rotl(hash ^ scramble(block_at(at, 4)), 13) * 5 + 0xe6546b64u;
  hash ^= scramble(block_at(whole, text.size() - whole));
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bu;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
  return hash ^ hash >> 16;
}

float cryptomatte_id(std::string_view name) {
  return std::bit_cast<float>(id_bits(name));
}

}  // namespace heckbert::report
