#pragma once
// Runs the real program as a child process, the way a shell would.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace heckbert::cli::testing {

struct Outcome {
  int exit_code = -1;  ///< -1 when a signal ended it
  int signal = 0;      ///< 0 when it exited by itself
  std::string out, err;
};

struct RunOptions {
  std::string input{};                               ///< what is typed into standard input
  std::map<std::string, std::string> environment{};  ///< added to a clean one
  std::filesystem::path folder{};                    ///< working directory; empty: ours
  bool full_output = false;                          ///< standard output is a device that is always full
  std::uint64_t largest_file = 0;                    ///< bytes that a file may have; 0: no limit
  bool as_nobody = false;                            ///< as a user without rights, when the tests run as root
  std::vector<std::string> launcher{};               ///< a program, and its arguments before ours; empty: none
};

/// Waits for the end. No HECKBERT_ variable of the caller reaches the program.
Outcome run(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Starts the program with its output on a terminal of its own; gives back all that appeared there.
std::string run_on_terminal(const std::vector<std::string>& arguments);

/// Starts the program, sends `signal` some time after `wait_for` has appeared on its standard error, and waits for the
/// end.
Outcome run_and_signal(const std::vector<std::string>& arguments, int signal, const std::string& wait_for,
                       std::chrono::milliseconds later = {});

/// A folder that is there for one test.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }
  std::string write(const std::string& name, const std::string& text) const;  ///< gives back the file's path
  std::vector<std::string> listing() const;                                   ///< sorted names

 private:
  std::filesystem::path path_;
};

std::string read_bytes(const std::filesystem::path& path);

/// Every command of the tool; the tests of help, documents and --json go through all of them.
inline const std::vector<std::vector<std::string>> kCommands{{"render"},
                                                             {"coverage"},
                                                             {"query"},
                                                             {"classify"},
                                                             {"paths"},
                                                             {"report"},
                                                             {"match"},
                                                             {"grammar", "list"},
                                                             {"grammar", "show"},
                                                             {"grammar", "equal"},
                                                             {"grammar", "subset"},
                                                             {"grammar", "translate"},
                                                             {"grammar", "disjoint"},
                                                             {"grammar", "partition"},
                                                             {"grammar", "words"},
                                                             {"grammar", "count"},
                                                             {"grammar", "identify"},
                                                             {"grammar", "explain"},
                                                             {"grammar", "dot"},
                                                             {"grammar", "minimize"},
                                                             {"grammar", "strategies"},
                                                             {"grammar", "lattice"},
                                                             {"grammar", "phases"},
                                                             {"grammar", "errors"},
                                                             {"scene", "list"},
                                                             {"scene", "check"},
                                                             {"verify"},
                                                             {"why"},
                                                             {"merge"},
                                                             {"record", "import"}};

}  // namespace heckbert::cli::testing
