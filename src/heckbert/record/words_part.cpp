#include <heckbert/record/words_part.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <array>

#include <heckbert/record/deep_rows.h>
#include <heckbert/record/exr.h>
#include <heckbert/record/record_header.h>

namespace heckbert::record::exr {

namespace {

struct BatchSample {
  std::uint32_t batch = 0;
  Rgb mean;
  std::uint64_t count = 0;
};

constexpr std::array<DeepChannel, 6> kChannels{{
    {"batch", Imf::UINT, offsetof(BatchSample, batch)},
    {"R", Imf::FLOAT, offsetof(BatchSample, mean) + offsetof(Rgb, r)},
    {"G", Imf::FLOAT, offsetof(BatchSample, mean) + offsetof(Rgb, g)},
    {"B", Imf::FLOAT, offsetof(BatchSample, mean) + offsetof(Rgb, b)},
    {"count0", Imf::UINT, offsetof(BatchSample, count)},
    {"count1", Imf::UINT, offsetof(BatchSample, count) + 4},
}};
constexpr DeepLayout kLayout{kChannels, sizeof(BatchSample)};

/// Words in a row: OpenEXR packs row by row, and this many pack well.
constexpr int kWordsPerRow = 256;

Window window_for(std::size_t words) {
  return {0, 0, kWordsPerRow, static_cast<int>((words + kWordsPerRow - 1) / kWordsPerRow)};
}

void append_word(DeepBand& band, const Record& record, std::size_t word) {
  const std::size_t before = band.samples.size();
  BatchSample sample;
  sample.count = record.counts[word];
  const auto append = [&] {
    const char* bytes = reinterpret_cast<const char*>(&sample);
    band.samples.insert(band.samples.end(), bytes, bytes + sizeof sample);
    sample.count = 0;
  };
  for (std::uint32_t b = 0; b < kBatches; ++b) {
    sample.batch = b;
    sample.mean = record.batch_means[word * kBatches + b];
    if (!is_black(sample.mean)) append();
  }
  sample.batch = 0;
  if (band.samples.size() == before) append();
  band.counts.push_back(static_cast<unsigned>((band.samples.size() - before) / sizeof sample));
}

}  // namespace

Imf::Header words_header(const Record& record) {
  Imf::Header header = part_header(record.info, kWordsPart, Imf::DEEPSCANLINE, window_for(record.words.size()));
  Imf::addComments(header,
                   "No picture: pixel number w, row by row, is word w of heckbert.words. It has a deep sample for each "
                   "batch of camera samples that saw the word: the mean of the picture as this batch alone has it.");
  for (const DeepChannel& channel : kChannels) header.channels().insert(channel.name, Imf::Channel(channel.type));
  return header;
}

void write_words(Imf::MultiPartOutputFile& file, int part, const Record& record) {
  std::size_t word = 0;
  write_deep(Imf::DeepScanLineOutputPart(file, part), window_for(record.words.size()), kLayout, {},
             [&](DeepBand& band) {
               for (std::size_t i = 0; i < band.window.pixel_count(); ++i, ++word)
                 if (word < record.words.size())
                   append_word(band, record, word);
                 else
                   band.counts.push_back(0);
             });
}

void read_words(Imf::MultiPartInputFile& file, std::uint64_t file_bytes, Record& record) {
  const std::size_t words = record.words.size();
  record.counts.resize(words);
  record.batch_means.resize(words * kBatches);
  if (words == 0) return;
  require(file.parts() > 1 && file.header(1).name() == kWordsPart, "the part 'words' is missing");
  require(window_of(file.header(1).dataWindow()) == window_for(words),
          "the part 'words' does not have as many words as the id manifest");
  std::vector<BatchSample> samples;
  const std::vector<std::size_t> offsets =
      read_deep(Imf::DeepScanLineInputPart(file, 1), kLayout, [&](std::size_t total) {
        require(can_unpack_to(total * sizeof(BatchSample), file_bytes),
                "the file is damaged: it promises more batches than it can hold");
        samples.resize(total);
        return reinterpret_cast<char*>(samples.data());
      });

  for (std::size_t w = 0; w < words; ++w) {
    for (std::size_t i = offsets[w]; i < offsets[w + 1]; ++i) {
      const BatchSample& sample = samples[i];
      require(sample.batch < kBatches, "the part 'words' has a batch that there is not");
      require(is_recordable(sample.mean), "the part 'words' has an energy that is negative or not finite");
      record.batch_means[w * kBatches + sample.batch] = sample.mean;
      record.counts[w] += sample.count;
    }
    require(record.counts[w] > 0, "the part 'words' has a word without contributions");
  }
}

}  // namespace heckbert::record::exr
