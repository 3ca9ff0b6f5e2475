#include <heckbert/cli/commands/render/result.h>

#include <utility>

#include <fmt/format.h>

#include <heckbert/cli/files.h>
#include <heckbert/cli/pictures.h>
#include <heckbert/cli/record_precision.h>
#include <heckbert/cli/scenes.h>
#include <heckbert/record/file.h>
#include <heckbert/report/facts.h>
#include <heckbert/report/numbers.h>
#include <heckbert/report/picture.h>

namespace heckbert::cli {

Result result_of(record::SumsStream sums, const record::TilePictures* pictures, const RenderOptions& options,
                 const std::vector<taxonomy::Grammar>& grammars, const Settings& settings) {
  Result result{.sums = std::move(sums)};
  const record::RenderInfo& info = result.sums.info;
  const bool can_be_added_to = !result.sums.folding && !options.adaptive;
  result.keeps_sums =
      !options.record.empty() && can_be_added_to && (options.exact || info.partial || !info.parts.empty());
  // Sums are of floats, even where halves were wanted.
  const record::Precision precision = result.keeps_sums ? record::Precision::Float : precision_of(options.precision);
  result.record = totals_of(result.sums, options.record.empty() ? record::Precision::Float : precision);
  result.record.info.precision = precision;
  result.classes = classes_of(result.record, grammars, settings.glossy, settings.confidence);
  if (pictures != nullptr) {
    result.beauty = pictures->beauty();
    result.images.assign(pictures->classes().begin(), pictures->classes().end());
  } else {
    result.images = images_of(result.record, rows_of(result.sums), result.classes);
    result.beauty = std::move(result.images.back());
    result.images.pop_back();
  }
  return result;
}

void write_outputs(const Outputs& outputs, const Result& result, bool with_cryptomatte, const Settings& settings,
                   const Console& console) {
  if (!outputs.picture.empty()) {
    std::vector<record::Layer> layers = layers_of(result.images, result.classes, settings.glossy);
    layers.insert(layers.begin(), record::Layer{"", result.beauty, {}});
    add_non_path_layers(result.record, layers);
    const record::Attachment attachment =
        with_cryptomatte ? cryptomatte_of(result.record, rows_of(result.sums), result.classes) : record::Attachment{};
    record::RenderInfo info = result.record.info;
    info.precision = record::Precision::Float;  // of sums, whatever the record rounds to
    write_to(outputs.picture, [&](const auto& path) { record::write_layers(layers, info, path, attachment); });
    for (const std::string& sentence : renamed(layers)) console.note(sentence);
  }
  if (!outputs.record.empty())
    write_to(outputs.record, [&](const auto& path) {
      result.keeps_sums ? record::write_sums(result.sums, path)
                        : record::write_record(result.record, result.sums, path);
    });
  if (!outputs.preview.empty())
    write_bytes(outputs.preview, png_of(result.beauty, report::auto_exposure(result.beauty)));
}

void tell_result(const Console& console, const Result& result, const Work& work) {
  const record::Record& record = result.record;
  console.note(fmt::format("{} samples in {:.2f} s, {:.2f} Mrays/s; {} found", report::grouped(record.tally.samples),
                           work.seconds, work.seconds > 0 ? static_cast<double>(work.rays) / work.seconds / 1e6 : 0,
                           report::counted(record.words.size(), "word")));
  for (const std::string& warning : report::warnings(record.info, record.tally)) console.note("warning: " + warning);
  console.note(report::folding(record));
  for (const ClassOfRecord& item : result.classes) {
    console.note(describe(item));
    console.note(item.never);
  }
}

report::Json to_json(const Outputs& outputs, const Result& result, const Work& work, const Settings& settings,
                     const import::Account& account) {
  const record::Record& record = result.record;
  report::Json json = report::document_of("heckbert.render");
  json["render"] = report::to_json(record.info);
  json["tally"] = report::to_json(record.info, record.tally);
  json["seconds"] = work.seconds;
  json["rays"] = work.rays;
  json["words"] = record.words.size();
  json["glossy_rule"] = report::name_of(settings.glossy);
  json["confidence"] = settings.confidence;
  json["classes"] = cli::to_json(result.classes);
  json["account"] = cli::to_json(account);
  json["files"] = {{"picture", outputs.picture}, {"record", outputs.record}, {"preview", outputs.preview}};
  return json;
}

}  // namespace heckbert::cli
