#include <heckbert/record/recorder.h>

int main() {
  heckbert::record::Assembler assembler({.scene = "none",
                                         .algorithm = "none",
                                         .width = 1,
                                         .height = 1,
                                         .window = {0, 0, 1, 1},
                                         .samples_per_pixel = 1,
                                         .version = "0"});
  return assembler.finish(false).words.empty() ? 0 : 1;
}
