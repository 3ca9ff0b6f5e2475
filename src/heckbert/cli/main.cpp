// heckbert, the command line: parse, run, exit code.

#include <heckbert/cli/command_line.h>

int main(int argc, char** argv) {
  using namespace heckbert::cli;
  const ExitCode code = guarded([&] {
    const Run run = parse(argc, argv);
    return run();
  });
  return static_cast<int>(code);
}
