// What a component does to the process that it lives in.
#include <fenv.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include <clocale>
#include <cstring>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>

#include "../allocation.h"
#include "generic.h"

extern char** environ;

namespace preshape::conformance {

namespace {

/// State of the process by name, as text that can be compared.
std::map<std::string, std::string> process_state() {
  std::map<std::string, std::string> state;
  state["the locale"] = std::setlocale(LC_ALL, nullptr);
  state["the rounding mode"] = std::to_string(fegetround());
#if defined(__SSE__)
  state["the floating-point mode"] = std::to_string(_mm_getcsr() & ~0x3fu);
#endif
  for (int number = 1; number < 32; ++number) {
    struct sigaction action {};
    sigaction(number, nullptr, &action);
    state["the signal handlers"] += fmt::format("{} ", reinterpret_cast<std::uintptr_t>(action.sa_handler));
  }
  std::error_code error;
  state["the working directory"] = std::filesystem::current_path(error).string();
  for (char** variable = environ; *variable; ++variable) state["the environment"] += std::string(*variable) + "\n";
  const mode_t mask = umask(0);
  umask(mask);
  state["the file mode mask"] = std::to_string(mask);
  const auto tasks = std::filesystem::directory_iterator("/proc/self/task", error);
  state["the number of threads"] = std::to_string(std::distance(begin(tasks), end(tasks)));
  state["the format of std::cout"] = fmt::format("{} {}", static_cast<int>(std::cout.flags()), std::cout.precision());
  return state;
}

/// Catches what is written to standard output and standard error while it lives.
class Caught {
 public:
  Caught() {
    flush();
    file_ = memfd_create("output", MFD_CLOEXEC);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      kept_[stream] = dup(stream);
      dup2(file_, stream);
    }
  }
  ~Caught() { close(file_); }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;

  std::string text() {
    flush();
    for (const auto& [stream, kept] : kept_) {
      dup2(kept, stream);
      close(kept);
    }
    std::string text(static_cast<std::size_t>(lseek(file_, 0, SEEK_END)), '\0');
    lseek(file_, 0, SEEK_SET);
    const ssize_t got = read(file_, text.data(), text.size());
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    return text;
  }

 private:
  static void flush() {
    std::cout.flush(), std::cerr.flush();
    fflush(nullptr);
  }
  int file_ = -1;
  std::map<int, int> kept_;
};

}  // namespace

void g15_silent(Context& context) {
  Caught caught;
  std::string failure;
  try {
    specimen(context).use();
    context.forget_registry();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  const std::string text = caught.text();
  context.require(failure.empty(), "it threw \"{}\"", failure);
  context.require(text.empty(), "it printed \"{}\"; results and errors are returned, progress is told", text.substr(0, 500));
}

void g16_process_state(Context& context) {
  const auto before = process_state();
  {
    Specimen whole = specimen(context);
    whole.use();
  }
  context.forget_registry();
  auto now = process_state();
  // Our own thread pools may have started; a thread that the library left would run code that is gone.
  for (const auto& [what, text] : before) {
    context.require(now[what] == text, "after it was loaded, used and destroyed, {} had changed from \"{}\" to \"{}\"", what,
                    text.substr(0, 200), now[what].substr(0, 200));
  }
}

void g22_leaks(Context& context) {
  if (!allocations_watched()) context.skip("a sanitizer looks for leaks in this build");
  constexpr int kRounds = 10;
  const auto rounds = [&context] {
    for (int i = 0; i < kRounds; ++i) specimen(context).use();
  };
  rounds();
  std::ptrdiff_t least = std::numeric_limits<std::ptrdiff_t>::max();
  // A cache may still fill in one stretch; what leaks grows in every one.
  for (int stretch = 0; stretch < 3 && least >= 16 * kRounds; ++stretch) {
    const HeapWatch watch;
    rounds();
    least = std::min(least, watch.growth());
  }
  context.require(least < 16 * kRounds, "made, used and destroyed {} times it leaves {} bytes each time", kRounds,
                  least / kRounds);
}

void g26_allocation_fails(Context& context) {
  if (!allocations_watched()) context.skip("allocations cannot be made to fail under a sanitizer");
  context.record();
  const auto before = specimen(context).use();
  for (std::size_t n = 1; n < 400; n += 1 + n / 20) {
    bool happened = false;
    try {
      AllocationFault fault(n);
      const auto use = [&] {
        specimen(context).use();
        happened = fault.happened();
      };
      use();
    } catch (const std::exception&) {
      happened = true;
    }
    if (!happened) break;
  }
  const auto now = specimen(context).use();
  context.require(same_bits(before, now), "after allocations that failed it answers otherwise: {}", difference(before, now));
}

}  // namespace preshape::conformance
