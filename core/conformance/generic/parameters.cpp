// What a component makes of its parameters.
#include <cmath>
#include <limits>

#include "generic.h"
#include "preshape/base/error.h"

namespace preshape::conformance {

namespace {

/// The message with which the parameters are refused; "" when they are not.
std::string refusal(Context& context, const Value& parameters) {
  try {
    specimen(context, parameters);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void require_refused(Context& context, const std::string& name, const Value& wrong, std::string_view why) {
  Value parameters = context.parameters();
  parameters.set(name, wrong);
  const std::string message = refusal(context, parameters);
  context.require(!message.empty(), "parameter {} = {} ({}) is taken without a word", name, wrong.text(), why);
  context.require(message.find(name) != std::string::npos, "parameter {} = {} is refused by \"{}\", which does not name it",
                  name, wrong.text(), message);
}

void require_bounds(Context& context, const ParameterDeclaration& d) {
  const bool is_number = d.type == ParameterType::kNumber || d.type == ParameterType::kInteger;
  if (!is_number) return;
  context.require(!std::isnan(d.minimum) && !std::isnan(d.maximum) && d.minimum <= d.maximum,
                  "parameter '{}' has the bounds {} .. {}, which let everything pass", d.name, d.minimum, d.maximum);
  require_refused(context, d.name, std::numeric_limits<double>::quiet_NaN(), "not a number");
  const auto off = [&](double by, double bound) -> Value {
    const double beyond = bound + by * std::max(1.0, std::abs(bound));
    return d.type == ParameterType::kInteger ? Value(static_cast<std::int64_t>(beyond)) : Value(beyond);
  };
  if (std::abs(d.minimum) < 1e15) require_refused(context, d.name, off(-1, d.minimum), "below its bounds");
  if (std::abs(d.maximum) < 1e15) require_refused(context, d.name, off(1, d.maximum), "above its bounds");
}

Value wrong_type(ParameterType type) {
  if (type == ParameterType::kText || type == ParameterType::kChoice) return Value(3.5);
  return Value("a text that is no number");
}

/// Everything finite, or refused as bad input.
void require_sane(Context& context, const Value& parameters) {
  std::vector<double> answers;
  try {
    answers = specimen(context, parameters).use();
  } catch (const InputError&) {
    return;
  }
  for (std::size_t i = 0; i < answers.size(); ++i) {
    context.require(std::isfinite(answers[i]), "with {} its answer {} of {} is {}", parameters.text(), i + 1,
                    answers.size(), answers[i]);
  }
}

}  // namespace

void g09_bad_parameters(Context& context) {
  const auto names = context.record().schema.names();
  Value parameters = context.parameters();
  const std::string unknown = names.empty() ? "no_such_parameter" : names.front() + "x";
  parameters.set(unknown, 1.0);
  const std::string message = refusal(context, parameters);
  context.require(message.find(unknown) != std::string::npos, "the unknown parameter '{}' is taken without a word", unknown);
  for (const auto& d : context.record().schema.declarations()) {
    require_bounds(context, d);
    if (d.type == ParameterType::kTable) require_refused(context, d.name, Value(3.5), "of a wrong type");
    else require_refused(context, d.name, wrong_type(d.type), "of a wrong type");
  }
}

void g10_fuzz(Context& context) {
  Random random = context.random("parameters");
  const auto& declarations = context.record().schema.declarations();
  if (declarations.empty()) context.skip("it has no parameters");
  for (const auto& d : declarations) {
    if (d.type != ParameterType::kNumber) continue;
    for (const double bound : {d.minimum, d.maximum}) {
      if (!std::isfinite(bound)) continue;
      Value parameters = context.parameters();
      parameters.set(d.name, bound);
      require_sane(context, parameters);
    }
  }
  for (int i = 0; i < context.cases(10); ++i) require_sane(context, drawn_parameters(context, random));
}

}  // namespace preshape::conformance
