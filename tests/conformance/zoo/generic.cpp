// One broken component for each G check that a component can fail by itself; whole libraries that are broken have
// files of their own.
#include <dlfcn.h>
#include <link.h>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "measure.h"

namespace {

using namespace zoo;
using D = ParameterDeclaration;

/// A parameter that changes the answers, so that components differ by it.
D bias() { return D::number("bias", 0.0, 0.0, 1.0, "1", "taken off every component"); }

struct Biased : Measure {
  static std::vector<D> parameters() { return {bias()}; }
  explicit Biased(const Parameters& p) : Measure(p), bias_(p.number("bias")) {}
  double component(Degrees q, Degrees w) const override { return std::max(0.0, Measure::component(q, w) - bias_); }
  double bias_;
};

struct ChangesDeclaration final : Measure {
  using Measure::Measure;
  static std::vector<D> parameters() { return {D::flag("here", true, "in process " + std::to_string(getpid()))}; }
};

struct KnowsEverything final : Measure {
  using Measure::Measure;
  const void* extension(const char*) const noexcept override { return this; }
};

struct Wordless final : Measure {
  using Measure::Measure;
  static std::vector<D> parameters() { return {D::flag("mystery", true, "")}; }
};

struct Boundless final : Measure {
  using Measure::Measure;
  static std::vector<D> parameters() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {D::number("anything", 0.0, nan, nan, "1", "whose bounds are not numbers")};
  }
};

struct DividesByZero final : Measure {
  static std::vector<D> parameters() { return {D::number("width", 1.0, 0.0, 2.0, "1", "by which differences are divided")}; }
  explicit DividesByZero(const Parameters& p) : Measure(p), width_(p.number("width")) {}
  double component(Degrees q, Degrees w) const override { return std::min(1.0, (Measure::component(q, w) - 1.0) / width_ + 1.0); }
  SimilarityScale scale(int) const noexcept override { return {-1e9, kComponents}; }
  double width_;
};

struct SwallowsNan final : Measure {
  using Measure::Measure;
  static auto capabilities() { return promises("rejects_nonfinite"); }
};

struct TakesAnySize final : Measure {
  using Measure::Measure;
  void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const override {
    for (int i = 0; i < patterns.count; ++i) scores.data()[i] = one(task, patterns[i]);
  }
};

struct ThrowsForeign final : Measure {
  using Measure::Measure;
  void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const override {
    if (scores.size() != static_cast<std::size_t>(patterns.count)) {
      throw std::logic_error("got " + std::to_string(scores.size()) + " scores for " + std::to_string(patterns.count));
    }
    Measure::compare(task, patterns, scores);
  }
};

struct Prints final : Measure {
  explicit Prints(const Parameters& p) : Measure(p) { std::puts("here I am"); }
};

struct SetsMask final : Measure {
  explicit SetsMask(const Parameters& p) : Measure(p) { umask(0123); }
};

/// Reads the pattern of its last call once more.
struct KeepsInputs final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override {
    if (const double* last = last_.exchange(pattern.crisp)) {
      [[maybe_unused]] const volatile double ghost = *static_cast<const volatile double*>(last);
    }
    return Measure::one(task, pattern);
  }
  mutable std::atomic<const double*> last_ = nullptr;
};

/// Writes what stands there already.
struct WritesInputs final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override {
    auto* first = const_cast<volatile double*>(pattern.crisp);
    *first = *first;
    return Measure::one(task, pattern);
  }
};

struct KnowsTheProcess final : Measure {
  using Measure::Measure;
  double component(Degrees q, Degrees w) const override {
    return Measure::component(q, w) * (1.0 - 1e-9 * (reinterpret_cast<std::uintptr_t>(&kHere) >> 12 & 0xffff));
  }
  static constexpr char kHere = 0;
};

/// The parameter of whichever component was made last.
double shared_bias = 0.0;
struct SharesParameters final : Measure {
  static std::vector<D> parameters() { return {bias()}; }
  explicit SharesParameters(const Parameters& p) : Measure(p) { shared_bias = p.number("bias"); }
  double component(Degrees q, Degrees w) const override { return std::max(0.0, Measure::component(q, w) - shared_bias); }
};

/// Adds up in a member, and gives others the time to do so too.
struct SharesScratch final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override {
    double parts[kComponents];
    component_scores(task, pattern, parts);
    sum_ = 0.0;
    for (int k = 0; k < kComponents; ++k) {
      const double before = sum_;
      sum_ = before + parts[k];
      if (k == 3) std::this_thread::sleep_for(std::chrono::microseconds(1));
    }
    return sum_;
  }
  mutable volatile double sum_ = 0.0;
};

struct Leaks final : Measure {
  explicit Leaks(const Parameters& p) : Measure(p), lost_(new double[50]) { lost_[0] = 1.0; }
  double* volatile lost_;
};

struct Stays final : Measure {
  explicit Stays(const Parameters& p) : Measure(p) {
    Dl_info info;
    if (dladdr(reinterpret_cast<void*>(&preshape_bindings_marker), &info)) dlopen(info.dli_fname, RTLD_NOW | RTLD_NODELETE);
  }
  static void preshape_bindings_marker() {}
};

/// Fills a cache when it is first used after a load, and leaves it there when the library goes.
struct LeavesCache final : Measure {
  explicit LeavesCache(const Parameters& p) : Measure(p) {
    static auto* const cache = new std::array<double, 500>();
    first_ = cache->data();
  }
  const double* volatile first_;
};

/// The same with memory that is not malloc's.
struct LeavesPages final : Measure {
  explicit LeavesPages(const Parameters& p) : Measure(p) {
    static void* const pages = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    std::memset(pages, 1, kBytes);
  }
  static constexpr std::size_t kBytes = 64 << 10;
};

/// Frees all that it takes, in blocks that malloc keeps for later, a little more each time.
struct FreesLate final : Measure {
  explicit FreesLate(const Parameters& p) : Measure(p) {
    const std::size_t kept = mallinfo2().fordblks;
    std::vector<std::unique_ptr<char[]>> blocks;
    // The first time: that a block of this size was freed tells malloc to keep as much.
    if (kept < kMore) blocks.push_back(std::make_unique_for_overwrite<char[]>(16 << 20));
    blocks.clear();
    for (std::size_t size = 0; size < std::min(kept + kMore, 16 * kMore); size += 64 << 10)
      blocks.push_back(std::make_unique<char[]>(64 << 10));
  }
  static constexpr std::size_t kMore = 512 << 10;
};

struct KnowsTheBatch final : Measure {
  using Measure::Measure;
  void compare(const PatternView& task, const PatternView& patterns, std::span<double> scores) const override {
    Measure::compare(task, patterns, scores);
    if (patterns.count > 6) scores[0] *= 0.999;
  }
};

struct CannotFail final : Measure {
  using Measure::Measure;
  SimilarityScale scale(int) const noexcept override {
    const auto room = std::make_unique<double[]>(1000);
    return {room[0] * 0.0, kComponents};
  }
};

struct SlowOnSubnormal final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override {
    for (int k = 0; k < kComponents; ++k) {
      if (std::fpclassify(task.crisp[k]) == FP_SUBNORMAL) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return Measure::one(task, pattern);
  }
};

/// Works alone only.
struct RefusesCompany final : Measure {
  using Measure::Measure;
  double one(const PatternView& task, const PatternView& pattern) const override {
    const auto is_collision = [](dl_phdr_info* library, std::size_t, void*) {
      return std::strstr(library->dlpi_name, "/plugins/collision/") ? 1 : 0;
    };
    if (dl_iterate_phdr(is_collision, nullptr)) throw InputError("there is another plugin in this process");
    return Measure::one(task, pattern);
  }
};

}  // namespace

PRESHAPE_PLUGIN(({"zoo.generic", "1.0.0", "BSD-3-Clause", "the preshape developers", "Components broken on purpose"}),
                ({"similarity/good_biased", "similarity/good_frees_late", "similarity/g02_changes_declaration", "similarity/g06_knows_everything",
                  "similarity/g07_wordless", "similarity/g09_boundless", "similarity/g10_divides_by_zero",
                  "similarity/g12_swallows_nan", "similarity/g13_takes_any_size",
                  "similarity/g14_throws_foreign", "similarity/g15_prints", "similarity/g16_sets_mask",
                  "similarity/g17_keeps_inputs", "similarity/g17_writes_inputs", "similarity/g19_knows_the_process",
                  "similarity/g20_shares_parameters", "similarity/g21_shares_scratch", "similarity/g22_leaks",
                  "similarity/g23_stays", "similarity/g23_leaves_cache", "similarity/g23_leaves_pages",
                  "similarity/g25_knows_the_batch", "similarity/g26_cannot_fail",
                  "similarity/g27_slow_on_subnormal", "similarity/g28_refuses_company"}),
                preshape::component<Biased>("good_biased", "without a fault, with a parameter"),
                preshape::component<FreesLate>("good_frees_late", "without a fault, hard on malloc"),
                preshape::component<ChangesDeclaration>("g02_changes_declaration", "declares itself by process"),
                preshape::component<KnowsEverything>("g06_knows_everything", "offers any extension"),
                preshape::component<Wordless>("g07_wordless", "a parameter without a text"),
                preshape::component<Boundless>("g09_boundless", "a parameter without bounds"),
                preshape::component<DividesByZero>("g10_divides_by_zero", "at one of its bounds"),
                preshape::component<SwallowsNan>("g12_swallows_nan", "promises to reject it"),
                preshape::component<TakesAnySize>("g13_takes_any_size", "looks at no size"),
                preshape::component<ThrowsForeign>("g14_throws_foreign", "throws std::logic_error"),
                preshape::component<Prints>("g15_prints", "greets"),
                preshape::component<SetsMask>("g16_sets_mask", "changes the file mode mask"),
                preshape::component<KeepsInputs>("g17_keeps_inputs", "reads an earlier input"),
                preshape::component<WritesInputs>("g17_writes_inputs", "writes to its input"),
                preshape::component<KnowsTheProcess>("g19_knows_the_process", "depends on an address"),
                preshape::component<SharesParameters>("g20_shares_parameters", "one parameter for all"),
                preshape::component<SharesScratch>("g21_shares_scratch", "one sum for all threads"),
                preshape::component<Leaks>("g22_leaks", "400 bytes each"),
                preshape::component<Stays>("g23_stays", "pins its library"),
                preshape::component<LeavesCache>("g23_leaves_cache", "4000 bytes a load"),
                preshape::component<LeavesPages>("g23_leaves_pages", "64 KiB a load, past malloc"),
                preshape::component<KnowsTheBatch>("g25_knows_the_batch", "answers by the size of the batch"),
                preshape::component<CannotFail>("g26_cannot_fail", "allocates where it must not throw"),
                preshape::component<SlowOnSubnormal>("g27_slow_on_subnormal", "waits"),
                preshape::component<RefusesCompany>("g28_refuses_company", "works without other plugins only"))
