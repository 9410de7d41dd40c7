#include "components.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/scripted");

namespace {

/// The nearest row that was learned decides.
constexpr const char* kNearest =
    "return {\n"
    "  fit = function(inputs, targets) return { inputs = inputs, targets = targets, third = 1 / 3, count = #inputs } end,\n"
    "  predict = function(model, input)\n"
    "    local best, least\n"
    "    for i, row in ipairs(model.inputs) do\n"
    "      local d = 0\n"
    "      for k = 1, #row do d = d + (row[k] - input[k]) ^ 2 end\n"
    "      if not least or d < least then best, least = model.targets[i], d end\n"
    "    end\n"
    "    local bits = {}\n"
    "    for k, bit in ipairs(best) do bits[k] = bit == 1 and 1 - model.third / 1000 or model.third / 1000 end\n"
    "    return bits\n"
    "  end }";

RowMatrix inputs() { return (RowMatrix(4, 2) << 0, 0, 0, 1, 1, 0, 1.1, 0.7).finished(); }
RowMatrix targets() { return (RowMatrix(4, 3) << 0, 0, 1, 0, 1, 1, 0, 1, 0, 1, 0, 0).finished(); }

RowMatrix predicted(const Classifier& classifier) {
  RowMatrix bits(4, 3);
  classifier.predict(inputs(), bits);
  return bits;
}

std::string failing(const std::string& inside) {
  const OneComponent component("classifier", "x", inside);
  try {
    const auto classifier = component->create<Classifier>("x");
    classifier->fit(inputs(), targets(), 1, nullptr);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Lua classifier: it learns, and without an outcome of its own the adapter measures one") {
  const OneComponent component("classifier", "x", kNearest);
  const auto classifier = component->create<Classifier>("x");
  CHECK_FALSE(classifier->trained());
  const TrainingOutcome outcome = classifier->fit(inputs(), targets(), 1, nullptr);
  CHECK(classifier->trained());
  CHECK(outcome.status == TrainingOutcome::Status::kArrived);
  CHECK(outcome.wrong_rows == 0);
  CHECK_NEAR(outcome.mean_squared_error, 1.0 / 9e6, 1e-12);
  CHECK((predicted(*classifier) - targets()).cwiseAbs().maxCoeff() < 0.001);
  const OneComponent telling("classifier", "x", "return { fit = function() return 1, { status = 'stalled', epochs = 7, wrong_rows = 2 } end, predict = function() return 0, 0, 0 end }");
  const TrainingOutcome told = telling->create<Classifier>("x")->fit(inputs(), targets(), 1, nullptr);
  CHECK(told.status == TrainingOutcome::Status::kStalled);
  CHECK(told.epochs == 7);
  CHECK(told.wrong_rows == 2);
  CHECK_NEAR(told.mean_squared_error, 5.0 / 12.0, kEps);
}

TEST_CASE("Lua classifier: what is saved and loaded predicts the same bits, in another object") {
  const OneComponent component("classifier", "x", kNearest);
  const auto first = component->create<Classifier>("x"), second = component->create<Classifier>("x");
  first->fit(inputs(), targets(), 1, nullptr);
  const std::string state = first->save();
  second->load(state);
  CHECK(second->trained());
  CHECK(predicted(*first) == predicted(*second));
  CHECK(second->save() == state);
}

TEST_CASE("Lua classifier: load refuses everything else and leaves what was learned") {
  const OneComponent component("classifier", "x", kNearest), other("classifier", "y", kNearest);
  const auto classifier = component->create<Classifier>("x"), stranger = other->create<Classifier>("y");
  classifier->fit(inputs(), targets(), 1, nullptr);
  stranger->fit(inputs(), targets(), 1, nullptr);
  const std::string state = classifier->save();
  const RowMatrix before = predicted(*classifier);
  const auto refusal = [&](const std::string& bytes) -> std::string {
    try {
      classifier->load(bytes);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(refusal("").find("these bytes are no state of classifier 'x' (another beginning)") == 0);
  for (std::size_t length = 1; length < state.size(); ++length) REQUIRE_FALSE(refusal(state.substr(0, length)).empty());
  for (std::size_t i = 0; i < state.size(); ++i) {
    std::string flipped = state;
    flipped[i] = static_cast<char>(flipped[i] ^ 1);
    REQUIRE_FALSE(refusal(flipped).empty());
  }
  CHECK(refusal(state + "x").find("the check sum does not fit") != std::string::npos);
  CHECK(refusal(stranger->save()).find("(it is one of 'y')") != std::string::npos);
  CHECK(predicted(*classifier) == before);
}

TEST_CASE("Lua classifier: a failed fit leaves what was learned before") {
  const OneComponent component("classifier", "x", "return { fit = function(inputs) if inputs[1][1] > 5 then error('too large') end return 0.25 end, predict = function(model) return model, model, model end }");
  const auto classifier = component->create<Classifier>("x");
  classifier->fit(inputs(), targets(), 1, nullptr);
  CHECK_THROWS_SAYING(classifier->fit(10 * inputs().array() + 10, targets(), 1, nullptr), ScriptError, "x.plugin.lua:4: too large");
  CHECK(predicted(*classifier)(0, 0) == 0.25);
}

TEST_CASE("Lua classifier: extend is given the model and where the new rows begin; without it all is learned anew") {
  const OneComponent component("classifier", "x",
                               "return { fit = function(inputs) return { fits = 1, from = 0, rows = #inputs } end,\n"
                               "extend = function(model, inputs, targets, first_new) return { fits = model.fits, from = first_new, rows = #targets } end,\n"
                               "predict = function(m) return m.fits / 10, m.from / 10, m.rows / 10 end }");
  const auto classifier = component->create<Classifier>("x");
  classifier->extend(inputs(), targets(), 0, 1, nullptr);  // nothing was learned before
  CHECK(predicted(*classifier)(0, 1) == 0.0);
  classifier->extend(inputs(), targets(), 2, 1, nullptr);
  CHECK(predicted(*classifier)(0, 1) == 0.3);
  CHECK(predicted(*classifier)(0, 2) == 0.4);
  CHECK_THROWS_SAYING(classifier->extend(inputs(), targets(), 5, 1, nullptr), InputError, "the first new row must be in 0 .. 4, got 5");
}

TEST_CASE("Lua classifier: its randomness is the seed's") {
  const OneComponent component("classifier", "x", "return { fit = function() return { math.random(), math.random() } end, predict = function(m) return m[1], m[2], 0 end }");
  const auto classifier = component->create<Classifier>("x");
  classifier->fit(inputs(), targets(), 4, nullptr);
  const std::string four = classifier->save();
  classifier->fit(inputs(), targets(), 5, nullptr);
  CHECK(classifier->save() != four);
  classifier->fit(inputs(), targets(), 4, nullptr);
  CHECK(classifier->save() == four);
}

TEST_CASE("Lua classifier: wrong rows, models and answers are told") {
  const OneComponent component("classifier", "x", kNearest);
  const auto classifier = component->create<Classifier>("x");
  RowMatrix bits(4, 3);
  CHECK_THROWS_SAYING(classifier->predict(inputs(), bits), InputError, "classifier 'x' has learned nothing yet; fit it first");
  CHECK_THROWS_SAYING(classifier->save(), InputError, "has learned nothing that could be saved");
  CHECK_THROWS_SAYING(classifier->fit(inputs(), 0.5 * targets(), 1, nullptr), InputError, "target 3 of row 1 must be 0 or 1, got 0.5");
  CHECK_THROWS_SAYING(classifier->fit(inputs(), targets().topRows(3), 1, nullptr), InputError, "4 x 2 inputs do not go with 3 x 3 targets");
  RowMatrix odd = inputs();
  odd(2, 1) = std::nan("");
  CHECK_THROWS_SAYING(classifier->fit(odd, targets(), 1, nullptr), InputError, "row 3 holds a number that is not finite");
  classifier->fit(inputs(), targets(), 1, nullptr);
  RowMatrix narrow(4, 2);
  CHECK_THROWS_SAYING(classifier->predict(inputs(), narrow), InputError, "has learned 2 inputs and 3 bits, but is asked with 4 x 2 inputs for 4 x 2 bits");

  const std::string predict = ", predict = function() return 0, 0, 0 end }";
  CHECK(failing("return { fit = function() end" + predict).ends_with("x.plugin.lua:4: classifier 'x': 'fit' must return a model, got nil"));
  CHECK(failing("return { fit = function() return { f = function() end } end" + predict).ends_with("classifier 'x': a model is plain data, but it holds a function"));
  CHECK(failing("return { fit = function() return 1, { statos = 'x' } end" + predict).find("classifier 'x', outcome: unknown key 'statos'; did you mean 'status'?") != std::string::npos);
  CHECK(failing("return { fit = function() return 1 end,\n predict = function() return 0, 2, 0 end }").ends_with("x.plugin.lua:5: classifier 'x': 'predict' must return probabilities in 0 .. 1, got 2 for the input (0, 0)"));
}

TEST_SUITE_END();
