#pragma once
// Other people's regular expression engines behind one face, each where it is installed.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bench {

/// Many patterns, compiled. Patterns and texts have one byte per letter and match as a whole.
class Engine {
 public:
  virtual ~Engine() = default;
  /// counts[i] += the number of texts that pattern i matches; text k is [begin[k], begin[k + 1]) of `bytes`.
  virtual void count(const char* bytes, std::span<const std::size_t> begin, std::vector<std::uint64_t>& counts) = 0;
};

struct EngineKind {
  std::string_view name;
  /// Nothing when the engine refuses the patterns. Empty where the engine is not installed.
  std::function<std::unique_ptr<Engine>(const std::vector<std::string>& patterns)> compile;
};

/// RE2::Set; PCRE2 with JIT, one pattern after the other; Hyperscan, all patterns in one database, block mode.
std::vector<EngineKind> engine_kinds();

}  // namespace bench
