// The part of Context that makes cases, and makes those small that break a property.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "context.h"
#include "preshape/base/error.h"
#include "preshape/base/value.h"

namespace preshape::conformance {

namespace {

constexpr int kMostShrinks = 3000;  // evaluations of the property

using Numbers = std::vector<double>;

std::size_t size_of(std::span<const Block> blocks) {
  std::size_t size = 0;
  for (const Block& block : blocks) size += static_cast<std::size_t>(block.size);
  return size;
}

/// The block of each number.
std::vector<const Block*> owners(std::span<const Block> blocks) {
  std::vector<const Block*> owners;
  for (const Block& block : blocks) owners.insert(owners.end(), static_cast<std::size_t>(block.size), &block);
  return owners;
}

double drawn(const Block& block, Random& random) {
  const double pick = random.uniform();
  if (pick < 0.1) return block.low;
  if (pick < 0.2) return block.high;
  if (pick < 0.4 && !block.corners.empty()) return block.corners[random.below(block.corners.size())];
  const double number = random.uniform(block.low, block.high);
  return block.whole ? std::clamp(std::floor(random.uniform(block.low, block.high + 1.0)), block.low, block.high)
                     : number;
}

/// Simpler numbers in the place of `number`, simplest first.
Numbers simpler(const Block& block, double number) {
  Numbers numbers;
  const auto offer = [&](double candidate) {
    if (block.whole) candidate = std::round(candidate);
    candidate = std::clamp(candidate, block.low, block.high);
    if (candidate != number && std::find(numbers.begin(), numbers.end(), candidate) == numbers.end()) {
      numbers.push_back(candidate);
    }
  };
  for (const double plain : {0.0, 1.0, -1.0}) offer(plain);
  for (const double digits : {1.0, 10.0, 100.0, 1000.0}) offer(std::round(number * digits) / digits);
  offer(number / 2.0);
  return numbers;
}

/// "": it is as simple, or simpler only by a later candidate.
bool is_simpler(double a, double b) {
  const auto cost = [](double x) {
    return x == 0.0 ? 0.0 : x == 1.0 ? 1.0 : 2.0 + static_cast<double>(number_text(x).size()) + 1e-3 * std::abs(x);
  };
  return cost(a) < cost(b);
}

}  // namespace

std::string case_text(std::span<const Block> blocks, Case numbers) {
  std::string text;
  std::size_t at = 0;
  for (const Block& block : blocks) {
    std::string values;
    for (int i = 0; i < block.size; ++i) values += (i ? " " : "") + number_text(numbers[at++]);
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", block.name, block.size == 1 ? values : "{" + values + "}");
  }
  return text;
}

void Context::for_all(std::span<const Block> blocks, int count, const Property& property) {
  const std::size_t size = size_of(blocks);
  const auto owner = owners(blocks);
  if (running_) {
    std::string names;
    for (const Block& block : blocks) names += fmt::format("{} {}\n", block.name, block.size);
    if (names.size() < RunningCase::kMostText) std::memcpy(running_->blocks, names.c_str(), names.size() + 1);
  }
  const auto found = [&](const Numbers& numbers) -> std::string {
    if (running_) running_->begin(numbers);
    std::string sentence;
    try {
      sentence = property(numbers);
    } catch (const Error& error) {
      sentence = fmt::format("it threw \"{}\"", error.what());
    }
    if (running_) running_->count = 0;
    return sentence;
  };
  const auto refuse = [&](Numbers numbers, std::string sentence) {
    int evaluations = 0;
    for (bool smaller = true; smaller && evaluations < kMostShrinks;) {
      smaller = false;
      for (std::size_t i = 0; i < size; ++i) {
        for (const double candidate : simpler(*owner[i], numbers[i])) {
          if (!is_simpler(candidate, numbers[i]) || ++evaluations > kMostShrinks) continue;
          Numbers trial = numbers;
          trial[i] = candidate;
          if (std::string still = found(trial); !still.empty()) {
            numbers = std::move(trial), sentence = std::move(still), smaller = true;
            break;
          }
        }
      }
    }
    fail("{}\n    input: {}", sentence, case_text(blocks, numbers));
  };

  Random draws = random("cases");
  Numbers numbers(size);
  const auto all = [&](const auto& value) {
    for (std::size_t i = 0; i < size; ++i) numbers[i] = value(*owner[i]);
    if (std::string sentence = found(numbers); !sentence.empty()) refuse(numbers, sentence);
  };
  all([](const Block& block) { return block.low; });
  all([](const Block& block) { return block.high; });
  all([](const Block& block) { return std::clamp(0.0, block.low, block.high); });
  for (int i = 0; i < count; ++i) all([&](const Block& block) { return drawn(block, draws); });
}

}  // namespace preshape::conformance
