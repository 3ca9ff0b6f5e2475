#include <heckbert/cli/findings.h>

#include <filesystem>
#include <utility>

namespace heckbert::cli {

namespace {

std::optional<std::filesystem::path> target_of(const std::string& file) {
  if (file.empty()) return {};
  if (file == "-") return std::filesystem::temp_directory_path() / "heckbert";
  return file;
}

}  // namespace

Findings::Findings(const record::RenderInfo& info, std::optional<record::SumsStream> begun, const Wanted& wanted)
    : begun_(std::move(begun)), spool_(info, target_of(wanted.file), wanted.folding) {
  if (wanted.pictures) pictures_.emplace(info, wanted.classes, wanted.rule);
}

void Findings::take(record::Tile tile) {
  if (pictures_) pictures_->add(tile);
  spool_.submit(std::move(tile));
}

record::SumsStream Findings::sums() const {
  return begun_ ? record::completed(*begun_, spool_.stream()) : spool_.stream();
}

}  // namespace heckbert::cli
