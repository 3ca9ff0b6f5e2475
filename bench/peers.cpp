#include "peers.h"

#include <stdexcept>

#ifdef HECKBERT_BENCH_RE2
#include <re2/set.h>
#endif
#ifdef HECKBERT_BENCH_PCRE2
#define PCRE2_CODE_UNIT_WIDTH 8
#include <pcre2.h>
#endif
#ifdef HECKBERT_BENCH_HYPERSCAN
#include <hs.h>
#endif

namespace bench {

namespace {

#ifdef HECKBERT_BENCH_RE2

class Re2Set : public Engine {
 public:
  explicit Re2Set(const std::vector<std::string>& patterns) : set_(options(), RE2::ANCHOR_BOTH) {
    for (const std::string& p : patterns)
      if (set_.Add(p, nullptr) < 0) throw std::runtime_error("RE2 refuses " + p);
    if (!set_.Compile()) throw std::runtime_error("RE2::Set does not compile");
  }
  void count(const char* bytes, std::span<const std::size_t> begin, std::vector<std::uint64_t>& counts) override {
    RE2::Set::ErrorInfo error{};
    for (std::size_t k = 0; k + 1 < begin.size(); ++k) {
      // No match and out of memory both return false; only the error tells them apart (google/re2 issue 136).
      if (!set_.Match({bytes + begin[k], begin[k + 1] - begin[k]}, &matched_, &error) &&
          error.kind == RE2::Set::kOutOfMemory)
        throw std::runtime_error("RE2::Set is out of memory");
      for (const int i : matched_) ++counts[static_cast<std::size_t>(i)];
    }
  }

 private:
  // With its default of 8 MiB it thrashes at 256 expressions; here it gets what it asks for.
  static RE2::Options options() {
    RE2::Options options(RE2::Latin1);
    options.set_max_mem(std::int64_t{1} << 30);
    return options;
  }
  RE2::Set set_;
  std::vector<int> matched_;
};

#endif
#ifdef HECKBERT_BENCH_PCRE2

class Pcre2Loop : public Engine {
 public:
  explicit Pcre2Loop(const std::vector<std::string>& patterns) : match_(pcre2_match_data_create(1, nullptr)) {
    for (const std::string& p : patterns) {
      int error = 0;
      PCRE2_SIZE where = 0;
      pcre2_code* code = pcre2_compile(reinterpret_cast<PCRE2_SPTR>(p.data()), p.size(),
                                       PCRE2_ANCHORED | PCRE2_ENDANCHORED, &error, &where, nullptr);
      if (code == nullptr || pcre2_jit_compile(code, PCRE2_JIT_COMPLETE) != 0)
        throw std::runtime_error("PCRE2 refuses " + p);
      codes_.push_back(code);
    }
  }
  Pcre2Loop(const Pcre2Loop&) = delete;
  Pcre2Loop& operator=(const Pcre2Loop&) = delete;
  ~Pcre2Loop() override {
    for (pcre2_code* code : codes_) pcre2_code_free(code);
    pcre2_match_data_free(match_);
  }
  void count(const char* bytes, std::span<const std::size_t> begin, std::vector<std::uint64_t>& counts) override {
    for (std::size_t k = 0; k + 1 < begin.size(); ++k)
      for (std::size_t i = 0; i < codes_.size(); ++i) {
        const auto* text = reinterpret_cast<PCRE2_SPTR>(bytes + begin[k]);
        counts[i] += pcre2_jit_match(codes_[i], text, begin[k + 1] - begin[k], 0, 0, match_, nullptr) >= 0;
      }
  }

 private:
  std::vector<pcre2_code*> codes_;
  pcre2_match_data* match_;
};

#endif
#ifdef HECKBERT_BENCH_HYPERSCAN

class Hyperscan : public Engine {
 public:
  explicit Hyperscan(const std::vector<std::string>& patterns) {
    std::vector<std::string> anchored;
    for (const std::string& p : patterns) anchored.push_back("^(?:" + p + ")$");
    std::vector<const char*> texts;
    std::vector<unsigned> flags(patterns.size(), HS_FLAG_SINGLEMATCH), ids;
    for (const std::string& p : anchored) {
      ids.push_back(static_cast<unsigned>(ids.size()));
      texts.push_back(p.c_str());
    }
    hs_compile_error_t* error = nullptr;
    if (hs_compile_multi(texts.data(), flags.data(), ids.data(), static_cast<unsigned>(texts.size()), HS_MODE_BLOCK,
                         nullptr, &database_, &error) != HS_SUCCESS) {
      const std::string why = error->message;
      hs_free_compile_error(error);
      throw std::runtime_error("Hyperscan: " + why);
    }
    if (hs_alloc_scratch(database_, &scratch_) != HS_SUCCESS) throw std::runtime_error("Hyperscan has no scratch");
  }
  Hyperscan(const Hyperscan&) = delete;
  Hyperscan& operator=(const Hyperscan&) = delete;
  ~Hyperscan() override {
    hs_free_scratch(scratch_);
    hs_free_database(database_);
  }
  void count(const char* bytes, std::span<const std::size_t> begin, std::vector<std::uint64_t>& counts) override {
    for (std::size_t k = 0; k + 1 < begin.size(); ++k)
      hs_scan(database_, bytes + begin[k], static_cast<unsigned>(begin[k + 1] - begin[k]), 0, scratch_, on_match,
              counts.data());
  }

 private:
  static int on_match(unsigned id, unsigned long long, unsigned long long, unsigned, void* counts) {
    ++static_cast<std::uint64_t*>(counts)[id];
    return 0;
  }
  hs_database_t* database_ = nullptr;
  hs_scratch_t* scratch_ = nullptr;
};

#endif

template <class T>
std::unique_ptr<Engine> make(const std::vector<std::string>& patterns) {
  return std::make_unique<T>(patterns);
}

}  // namespace

std::vector<EngineKind> engine_kinds() {
  std::vector<EngineKind> kinds{{"RE2::Set", {}}, {"PCRE2 JIT, in a loop", {}}, {"Hyperscan", {}}};
#ifdef HECKBERT_BENCH_RE2
  kinds[0].compile = make<Re2Set>;
#endif
#ifdef HECKBERT_BENCH_PCRE2
  kinds[1].compile = make<Pcre2Loop>;
#endif
#ifdef HECKBERT_BENCH_HYPERSCAN
  kinds[2].compile = make<Hyperscan>;
#endif
  return kinds;
}

}  // namespace bench
