#include <heckbert/report/coverage.h>

int main() {
  heckbert::record::Record record;
  record.info = {.width = 1, .height = 1, .window = {0, 0, 1, 1}, .samples_per_pixel = 1};
  record.offsets = {0, 0};
  const auto coverage = heckbert::report::coverage(record, heckbert::taxonomy::builtin_grammars().grammars);
  return coverage.grammars.empty() ? 1 : 0;
}
