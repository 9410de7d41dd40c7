#pragma once

#include <string>

#include "context.h"

namespace preshape::conformance {

/// How a check ended, with the words for a person.
struct Result {
  Outcome outcome = Outcome::kPass;
  std::string text;      ///< unless passed: what was found, on which input
  double seconds = 0.0;
};

/// Runs the check in this process.
Result run_here(const Check& check, const Subject& subject, const Settings& settings, RunningCase* running);

/// A check that runs in a child process with a group of its own, which is killed when it ends or at the time
/// limit. Its output is caught.
class Child {
 public:
  Child(const Check& check, Subject subject, const Settings& settings);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  const Check& check() const { return check_; }
  /// Waits at most that long. @returns whether it has ended
  bool wait(int milliseconds);
  /// Of a child that has ended.
  const Result& result() const { return result_; }

 private:
  bool read_some(int& descriptor, std::string& text, std::size_t most);
  void finish(int status, bool in_time);
  double seconds() const;

  const Check& check_;
  RunningCase* running_ = nullptr;
  int result_pipe_ = -1, output_pipe_ = -1;
  int pid_ = -1;
  double began_ = 0.0;
  std::string answer_, output_;
  Result result_;
};

}  // namespace preshape::conformance
