#include "fresh_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <iterator>

#include "preshape/base/error.h"
#include "preshape/script/setting.h"

namespace preshape::conformance {

namespace {

std::string read_all(int descriptor) {
  std::string text;
  char buffer[4096];
  for (ssize_t got = 0; (got = read(descriptor, buffer, sizeof buffer)) > 0;) text.append(buffer, static_cast<std::size_t>(got));
  return text;
}

/// An unnamed file with the text in it, read from its begin.
FILE* file_of(std::string_view text) {
  FILE* file = std::tmpfile();
  if (!file) return nullptr;
  std::fwrite(text.data(), 1, text.size(), file);
  std::rewind(file);
  return file;
}

std::vector<std::string> arguments_for(const Check& check, const Subject& subject, const Settings& settings) {
  std::vector<std::string> arguments = {settings.command.string(), "conform", subject.file.string(), "--component",
                                        subject.title(), "--only", check.id, "--seed", std::to_string(settings.seed),
                                        "--answer"};
  if (!settings.parameters.is_nil()) {
    for (const auto& [key, value] : settings.parameters.entries()) {
      arguments.insert(arguments.end(), {"--set", key + "=" + value.text()});
    }
  }
  return arguments;
}

}  // namespace

std::string ask_fresh_process(const Check& check, const Subject& subject, const Settings& settings,
                              std::string_view input) {
  std::vector<std::string> arguments = arguments_for(check, subject, settings);
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  FILE* const in = file_of(input);
  int out[2];
  if (!in || pipe(out) != 0) throw Failure{"the system gives no process to ask; free memory or files"};
  const pid_t child = fork();
  if (child == 0) {
    dup2(fileno(in), STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    close(out[0]), close(out[1]);
    execv(argv[0], argv.data());
    _exit(127);
  }
  close(out[1]);
  const std::string answer = read_all(out[0]);
  close(out[0]);
  std::fclose(in);
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw Failure{fmt::format("in a process of its own it ended with status {}: {}",
                              WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), answer)};
  }
  return answer;
}

int answer_as_fresh_process(const Check& check, const Subject& subject, const Settings& settings) {
  const std::string input{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  // The answer alone goes to standard output, whatever the component prints.
  const int out = dup(STDOUT_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  Context context(check, subject, settings, nullptr);
  std::string answer;
  int status = 1;
  try {
    answer = check.fresh(context, input);
    status = 0;
  } catch (const Failure& failure) {
    answer = failure.text;
  } catch (const Skip& skip) {
    answer = skip.reason;
  } catch (const std::exception& error) {
    answer = error.what();
  }
  for (std::string_view left = answer; !left.empty();) {
    const ssize_t wrote = write(out, left.data(), left.size());
    if (wrote <= 0) return 1;
    left.remove_prefix(static_cast<std::size_t>(wrote));
  }
  return status;
}

std::string hex_text(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

std::string hex_text(std::span<const double> numbers) {
  return hex_text(std::string_view(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()));
}

}  // namespace preshape::conformance
