#include "child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>

#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

constexpr std::size_t kMostOutput = 4000;  // characters of a child's output that are told

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) text += (text.empty() ? "" : "; ") + line;
  return text;
}

Result judged(Context& context) {
  try {
    const Check& check = context.check();
    if (*check.capability && !context.declares(check.capability)) {
      return {Outcome::kSkip, fmt::format("it does not promise to be '{}'", check.capability)};
    }
    check.run(context);
    if (!context.warnings().empty()) return {Outcome::kWarn, joined(context.warnings())};
    return {Outcome::kPass, ""};
  } catch (const Failure& failure) {
    return {Outcome::kFail, failure.text};
  } catch (const Skip& skip) {
    return {Outcome::kSkip, skip.reason};
  } catch (const std::exception& error) {
    return {Outcome::kFail, fmt::format("it threw \"{}\"", error.what())};
  } catch (...) {
    return {Outcome::kFail, "it threw something that is no std::exception"};
  }
}

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t wrote = write(descriptor, text.data(), text.size());
    if (wrote <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(wrote));
  }
}

/// The child's limits: no core files, and processor time as a second line behind the parent's clock.
void limit_process(double seconds) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const auto cpu = static_cast<rlim_t>(8 * seconds + 2);
  const rlimit time{cpu, cpu + 1};
  setrlimit(RLIMIT_CPU, &time);
}

}  // namespace

Result run_here(const Check& check, const Subject& subject, const Settings& settings, RunningCase* running) {
  const double began = now();
  Context context(check, subject, settings, running);
  Result result = judged(context);
  result.seconds = now() - began;
  return result;
}

Child::Child(const Check& check, Subject subject, const Settings& settings) : check_(check), began_(now()) {
  int result[2], output[2];
  running_ = static_cast<RunningCase*>(
      mmap(nullptr, sizeof(RunningCase), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (running_ == MAP_FAILED || pipe2(result, O_CLOEXEC) != 0 || pipe2(output, O_CLOEXEC) != 0) {
    throw Error("the system gives no process for a check; free memory or files, or run with --in-process");
  }
  fflush(nullptr);  // or the child would print what waits in our buffers
  pid_ = fork();
  if (pid_ == 0) {
    setpgid(0, 0);
    limit_process(check.seconds);
    dup2(output[1], STDOUT_FILENO);
    dup2(output[1], STDERR_FILENO);
    const Result found = run_here(check, subject, settings, running_);
    write_all(result[1], fmt::format("{}\n{}", static_cast<int>(found.outcome), found.text));
    fflush(nullptr);
    _exit(0);
  }
  if (pid_ < 0) throw Error("the system gives no process for a check; run with --in-process");
  setpgid(pid_, pid_);
  close(result[1]), close(output[1]);
  result_pipe_ = result[0], output_pipe_ = output[0];
}

Child::~Child() {
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (result_pipe_ >= 0) close(result_pipe_);
  if (output_pipe_ >= 0) close(output_pipe_);
  munmap(running_, sizeof(RunningCase));
}

double Child::seconds() const { return now() - began_; }

bool Child::read_some(int& descriptor, std::string& text, std::size_t most) {
  char buffer[4096];
  const ssize_t got = read(descriptor, buffer, sizeof buffer);
  if (got <= 0) {
    close(descriptor);
    descriptor = -1;
    return false;
  }
  text.append(buffer, std::min(static_cast<std::size_t>(got), most - std::min(most, text.size())));
  return true;
}

bool Child::wait(int milliseconds) {
  pollfd files[2] = {{result_pipe_, POLLIN, 0}, {output_pipe_, POLLIN, 0}};
  poll(files, 2, milliseconds);
  if (result_pipe_ >= 0 && files[0].revents) read_some(result_pipe_, answer_, std::size_t{1} << 20);
  if (output_pipe_ >= 0 && files[1].revents) read_some(output_pipe_, output_, kMostOutput);
  int status = 0;
  const bool late = seconds() > check_.seconds;
  if (waitpid(pid_, &status, WNOHANG) == 0) {
    if (!late) return false;
    kill(-pid_, SIGKILL);
    waitpid(pid_, &status, 0);
  } else {
    kill(-pid_, SIGKILL);  // whatever it left running
  }
  pid_ = -1;
  // Descendants are gone, so both pipes end.
  while (result_pipe_ >= 0 && read_some(result_pipe_, answer_, std::size_t{1} << 20)) {}
  while (output_pipe_ >= 0 && read_some(output_pipe_, output_, kMostOutput)) {}
  finish(status, !late || WIFEXITED(status));
  return true;
}

void Child::finish(int status, bool in_time) {
  const std::string running = running_->text();
  const auto newline = answer_.find('\n');
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && newline != std::string::npos) {
    result_ = {static_cast<Outcome>(std::stoi(answer_.substr(0, newline))), answer_.substr(newline + 1)};
  } else if (!in_time) {
    result_ = {Outcome::kTimeout, fmt::format("it had not ended after {} s", check_.seconds)};
  } else if (WIFSIGNALED(status)) {
    result_ = {Outcome::kCrash, fmt::format("it was ended by SIG{} ({})", sigabbrev_np(WTERMSIG(status)),
                                            strsignal(WTERMSIG(status)))};
  } else {
    result_ = {Outcome::kCrash, fmt::format("it ended the process with status {}", WEXITSTATUS(status))};
  }
  result_.seconds = seconds();
  if (result_.outcome >= Outcome::kCrash && !running.empty()) result_.text += "\n    input: " + running;
  if (is_bad(result_.outcome) && !output_.empty()) result_.text += "\n    it printed: " + output_;
}

}  // namespace preshape::conformance
