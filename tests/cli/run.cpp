#include "cli/run.h"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace heckbert::cli::testing {
namespace {

namespace fs = std::filesystem;

/// Replaces this process by the program. Does not return.
[[noreturn]] void become(const std::vector<std::string>& arguments,
                         const std::map<std::string, std::string>& environment,
                         const std::vector<std::string>& launcher = {}) {
  std::vector<std::string> variables{"PATH=/usr/bin:/bin", "HOME=/nonexistent", "TERM=xterm"};
  for (const auto& [name, value] : environment) variables.push_back(name + "=" + value);
  for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) variables.push_back(std::string(name) + "=" + value);
  std::vector<std::string> words = launcher;
  words.emplace_back(HECKBERT_EXECUTABLE);
  words.insert(words.end(), arguments.begin(), arguments.end());

  const auto pointers = [](std::vector<std::string>& texts) {
    std::vector<char*> list;
    for (std::string& text : texts) list.push_back(text.data());
    list.push_back(nullptr);
    return list;
  };
  execve(words.front().c_str(), pointers(words).data(), pointers(variables).data());
  _exit(127);
}

void redirect(const fs::path& file, int flags, int descriptor) {
  const int opened = open(file.c_str(), flags, 0600);
  if (opened < 0) _exit(126);
  dup2(opened, descriptor);
  close(opened);
}

struct Child {
  TemporaryFolder streams;  ///< its standard streams, as files
  pid_t pid = -1;
};

void start(Child& child, const std::vector<std::string>& arguments, const RunOptions& options) {
  child.streams.write("in", options.input);
  child.pid = fork();
  if (child.pid < 0) throw std::runtime_error("fork failed");
  if (child.pid > 0) return;
  redirect(child.streams / "in", O_RDONLY, STDIN_FILENO);
  if (options.full_output)
    redirect("/dev/full", O_WRONLY, STDOUT_FILENO);
  else
    redirect(child.streams / "out", O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
  redirect(child.streams / "err", O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(126);
  if (options.largest_file > 0) {
    // Ignored, so that writing fails with an error as on a full disk.
    const rlimit limit{options.largest_file, options.largest_file};
    if (std::signal(SIGXFSZ, SIG_IGN) == SIG_ERR || setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(126);
  }
  constexpr uid_t kNobody = 65534;
  if (options.as_nobody && getuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(126);
  become(arguments, options.environment, options.launcher);
}

Outcome finish(const Child& child) {
  int status = 0;
  waitpid(child.pid, &status, 0);
  Outcome outcome;
  if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = read_bytes(child.streams / "out");
  outcome.err = read_bytes(child.streams / "err");
  return outcome;
}

}  // namespace

Outcome run(const std::vector<std::string>& arguments, const RunOptions& options) {
  Child child;
  start(child, arguments, options);
  return finish(child);
}

Outcome run_and_signal(const std::vector<std::string>& arguments, int signal, const std::string& wait_for,
                       std::chrono::milliseconds later) {
  Child child;
  start(child, arguments, {});
  // The line is printed just before tracing begins.
  for (int tries = 0; tries < 2000; ++tries) {
    if (read_bytes(child.streams / "err").find(wait_for) != std::string::npos) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::this_thread::sleep_for(later);
  kill(child.pid, signal);
  return finish(child);
}

std::string run_on_terminal(const std::vector<std::string>& arguments) {
  winsize size{};
  size.ws_col = 100;
  size.ws_row = 40;
  int terminal = -1;
  const pid_t pid = forkpty(&terminal, nullptr, nullptr, &size);
  if (pid < 0) throw std::runtime_error("forkpty failed");
  if (pid == 0) become(arguments, {});
  std::string seen;
  char buffer[4096];
  for (ssize_t got = 0; (got = read(terminal, buffer, sizeof buffer)) > 0;)
    seen.append(buffer, static_cast<std::size_t>(got));
  close(terminal);
  waitpid(pid, nullptr, 0);
  return seen;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "heckbert-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path_ / name, std::ios::binary) << text;
  return (path_ / name).string();
}

std::vector<std::string> TemporaryFolder::listing() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace heckbert::cli::testing
