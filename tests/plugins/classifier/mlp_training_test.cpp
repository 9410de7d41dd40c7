#include "training.h"

#include <cmath>
#include <set>

#include "cube_lessons.h"
#include "levenberg_marquardt.h"
#include "preshape/base/error.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::mlp;
using preshape::test::matrices;
using preshape::test::pretraining;
using preshape::test::registry;

TEST_SUITE_BEGIN("plugins/classifier");

namespace {

using Status = TrainingOutcome::Status;

std::shared_ptr<Classifier> mlp_with(Value::Table parameters) {
  return registry().create<Classifier>("mlp", Value::table(std::move(parameters)));
}

/// Twelve rows at each of two inputs, of which a quarter and two thirds have a one.
constexpr double kShares[] = {0.25, 2.0 / 3.0};
Rows shares_lesson(const Shape& shape) {
  Rows rows(shape, 24);
  for (std::size_t r = 0; r < 24; ++r) {
    rows.input(r)[0] = r < 12 ? -1.0f : 1.0f;
    rows.target(r)[0] = static_cast<double>(r % 12) + 0.5 < kShares[r / 12] * 12 ? 1.0f : 0.0f;
  }
  return rows;
}

/// The loss after many moves.
double loss_after(Method& method, Network& network, const Rows& rows, Loss loss, int moves) {
  std::vector<float> outputs(rows.targets.size());
  for (int i = 0; i < moves; ++i) {
    method.look(network, rows, outputs);
    if (!method.move(network, rows)) break;
  }
  method.look(network, rows, outputs);
  return loss_of(outputs, rows.targets, loss);
}

Lesson numbered_lesson(std::size_t count) {
  const Shape shape{1, 2, 1};
  Lesson lesson{Rows(shape, count), std::vector<float>(count), Coding::plain(1)};
  for (std::size_t r = 0; r < count; ++r) lesson.rows.input(r)[0] = static_cast<float>(r);
  return lesson;
}

}  // namespace

TEST_CASE("MLP trainers: where rows repeat with different bits, each that goes downhill ends at the bits' shares") {
  // In closed form: at each input the best output is the share of ones there, p, under either loss; so the least
  // cross entropy is 12 H(1/4) + 12 H(2/3), and the least half squared error 6 p (1 - p) each.
  const Shape shape{1, 4, 1};
  const Rows rows = shares_lesson(shape);
  for (const Loss loss : {Loss::kCrossEntropy, Loss::kSquared}) {
    double least = 0.0;
    for (const double p : kShares) {
      least += loss == Loss::kSquared ? 6 * p * (1 - p) : -12 * (p * std::log(p) + (1 - p) * std::log(1 - p));
    }
    for (const int which : {0, 1, 2}) {
      CAPTURE(which);
      Random random(5);
      Network network = Network::random(shape, 0.5f, random);
      const auto method = which == 0   ? rprop(shape, loss, 0.0f)
                          : which == 1 ? lbfgs(shape, loss, 0.0f)
                                       : levenberg_marquardt(shape, loss);
      const double reached = loss_after(*method, network, rows, loss, 300);
      CHECK(reached >= least * (1 - 1e-6));  // outputs are floats
      CHECK_NEAR(reached, least, 1e-4 * least);
    }
  }
}

TEST_CASE("MLP trainers: the second-order ones need far fewer moves to the same loss than iRPROP-") {
  const Shape shape{1, 4, 1};
  const Rows rows = shares_lesson(shape);
  const double least = -12 * (std::log(0.25) / 4 + 0.75 * std::log(0.75) + std::log(2.0 / 3) * 2 / 3 + std::log(1.0 / 3) / 3);
  const auto moves_to = [&](std::unique_ptr<Method> method) {
    Random random(6);
    Network network = Network::random(shape, 0.5f, random);
    int moves = 0;
    while (moves < 300 && loss_after(*method, network, rows, Loss::kCrossEntropy, 1) > least * 1.0001) ++moves;
    return moves;
  };
  const int first_order = moves_to(rprop(shape, Loss::kCrossEntropy, 0.0f)),
            quasi_newton = moves_to(lbfgs(shape, Loss::kCrossEntropy, 0.0f)),
            gauss_newton = moves_to(levenberg_marquardt(shape, Loss::kCrossEntropy));
  MESSAGE("moves: rprop ", first_order, ", lbfgs ", quasi_newton, ", levenberg_marquardt ", gauss_newton);
  CHECK(quasi_newton < first_order);
  CHECK(gauss_newton < quasi_newton);
}

TEST_CASE("MLP trainers: Levenberg-Marquardt's residuals and derivatives give the gradient, which is that of finite "
          "differences, and the matrix of the squared error is that of the outputs' own differences") {
  const Shape shape{3, 5, 2};
  Random random(7);
  const Network network = Network::random(shape, 1.0f, random);
  Rows rows(shape, 6);
  for (float& x : rows.inputs) x = static_cast<float>(random.uniform(-2, 2));
  for (std::size_t r = 0; r < rows.count; ++r) rows.input(r)[3] = 1.0f;
  for (float& t : rows.targets) t = static_cast<float>(random.below(2));
  std::vector<float> outputs(rows.targets.size()), same(outputs.size());
  for (const Loss loss : {Loss::kCrossEntropy, Loss::kSquared}) {
    std::vector<float> gradient(shape.weights());
    network.add_gradient(rows, loss, gradient, outputs);
    const Linearised all = linearise(network, rows, 0, rows.count, loss, same);
    CHECK(outputs == same);
    const Eigen::VectorXd product = all.jacobian.transpose() * all.residuals;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      CHECK_NEAR(product[static_cast<Eigen::Index>(i)], static_cast<double>(gradient[i]), 1e-5);  // sums in float
    }
  }
  const Linearised squared = linearise(network, rows, 2, 3, Loss::kSquared, std::span(same).first(6));
  std::vector<float> hidden(shape.stride()), above(2), below(2);
  for (std::size_t i = 0; i < shape.weights(); ++i) {
    constexpr float kStep = 1.0f / 256;
    Network more = network, less = network;
    more.weights()[i] += kStep, less.weights()[i] -= kStep;
    for (std::size_t r = 0; r < 3; ++r) {
      more.forward(rows.input(2 + r), hidden.data(), above.data());
      less.forward(rows.input(2 + r), hidden.data(), below.data());
      for (std::size_t k = 0; k < 2; ++k) {
        const double difference = (above[k] - below[k]) / (2 * kStep);
        const std::size_t place = i % shape.stride();  // the padding and the constant one's way in are not used
        const bool used = place < 5 || (place == 5 && i >= shape.inputs() * shape.stride());
        CHECK_NEAR(squared.jacobian(static_cast<Eigen::Index>(2 * r + k), static_cast<Eigen::Index>(i)),
                   used ? difference : 0.0, 1e-4);  // step^2, and rounding of floats over the step
      }
    }
  }
}

TEST_CASE("MLP trainers: Levenberg-Marquardt moves alike whether it solves for the rows or for the weights") {
  const Shape shape{1, 4, 1};
  const Rows many = shares_lesson(shape);  // 24 residuals, 24 weights: solved for the rows
  REQUIRE(many.targets.size() == shape.weights());
  Rows more(shape, 48);  // more residuals than weights: solved for the weights
  for (std::size_t r = 0; r < 48; ++r) {
    more.input(r)[0] = many.input(r / 2)[0];
    more.target(r)[0] = many.target(r / 2)[0];
  }
  Random random(8);
  const Network start = Network::random(shape, 0.5f, random);
  Network a = start, b = start;
  const auto rows_solver = levenberg_marquardt(shape, Loss::kCrossEntropy),
             weights_solver = levenberg_marquardt(shape, Loss::kCrossEntropy);
  // Every row twice is twice the loss everywhere, so that both end at the same minimum.
  const double once = loss_after(*rows_solver, a, many, Loss::kCrossEntropy, 100),
               twice = loss_after(*weights_solver, b, more, Loss::kCrossEntropy, 100);
  CHECK_NEAR(twice, 2 * once, 1e-4 * twice);
}

TEST_CASE("MLP trainers: L-BFGS and Levenberg-Marquardt learn the 24 pretraining rows from each of 8 seeds") {
  const auto m = matrices(pretraining());
  for (const char* trainer : {"lbfgs", "levenberg_marquardt"}) {
    INFO(std::string(trainer));
    std::int64_t most = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto classifier = mlp_with({{"trainer", trainer}, {"committee", 1}, {"hidden", 20}});
      const auto outcome = classifier->fit(m.inputs, m.targets, seed, nullptr);
      CHECK(outcome.status == Status::kArrived);
      CHECK(outcome.restarts == 0);
      most = std::max(most, outcome.epochs);
    }
    MESSAGE(std::string(trainer), ": at most ", most, " epochs");
    CHECK(most < 60);  // iRPROP- takes about as many again
  }
}

TEST_CASE("MLP trainers: a system too large to be solved is refused by name") {
  const auto m = matrices(pretraining());
  RowMatrix inputs = m.inputs.replicate(50, 1), targets = m.targets.replicate(50, 1);
  const auto classifier = mlp_with({{"trainer", "levenberg_marquardt"}, {"hidden", 400}});
  CHECK_THROWS_SAYING(classifier->fit(inputs, targets, 1, nullptr), InputError,
                      "unknowns, of at most 8192; take fewer hidden units or another trainer");
}

TEST_CASE("MLP early stopping: rows are held out once each, and the others are learned") {
  const Lesson lesson = numbered_lesson(40);
  Random random(1);
  const Parts parts = hold_out(lesson, 0.25, random);
  CHECK(parts.held_out.rows.count == 10);
  CHECK(parts.learned.rows.count == 30);
  std::multiset<float> seen;
  for (const Lesson* part : {&parts.learned, &parts.held_out}) {
    for (std::size_t r = 0; r < part->rows.count; ++r) seen.insert(part->rows.input(r)[0]);
  }
  CHECK(seen.size() == 40);
  CHECK(std::set<float>(seen.begin(), seen.end()).size() == 40);
  CHECK(hold_out(numbered_lesson(2), 0.01, random).held_out.rows.count == 1);
}

TEST_CASE("MLP early stopping: where bits are noise the run ends early and keeps the weights that knew the held-out "
          "rows best") {
  // Nothing can be known of the held-out bits but their share; learning the others by heart makes it worse.
  const Shape shape{6, 30, 1};
  Random draws(2);
  Lesson lesson{Rows(shape, 120), {}, Coding::plain(1)};
  for (std::size_t r = 0; r < 120; ++r) {
    for (int i = 0; i < 6; ++i) lesson.rows.input(r)[i] = static_cast<float>(draws.uniform(-1, 1));
    lesson.rows.target(r)[0] = static_cast<float>(draws.below(2));
    lesson.bits.push_back(lesson.rows.target(r)[0]);
  }
  TrainingSettings settings;
  settings.max_epochs = 5000, settings.validation = 0.3, settings.patience = 40;
  Random random(3), again(3);
  const Trained stopped = train(lesson, shape, settings, random, [](int, double) {});
  CHECK(stopped.stopped_early);
  CHECK_FALSE(stopped.arrived);
  CHECK(stopped.restarts == 0);
  const Parts parts = hold_out(lesson, settings.validation, again);
  const auto error = [&](const Network& network) {
    std::vector<float> hidden(shape.stride()), output(parts.held_out.rows.count);
    for (std::size_t r = 0; r < output.size(); ++r) network.forward(parts.held_out.rows.input(r), hidden.data(), &output[r]);
    return fit_of(parts.held_out, output).mean_squared_error;
  };
  // The same run once more, move by move.
  Network network = Network::random(shape, settings.weight_range, again);
  const auto method = rprop(shape, settings.loss, settings.weight_decay);
  std::vector<float> outputs(parts.learned.rows.targets.size());
  double best = 1.0, last = 1.0;
  for (int epoch = 0; epoch <= stopped.epochs; ++epoch) {
    method->look(network, parts.learned.rows, outputs);
    last = error(network);
    best = std::min(best, last);
    method->move(network, parts.learned.rows);
  }
  CHECK(error(stopped.network) == best);
  CHECK(best < last);
  CHECK(best < 0.27);
}

TEST_CASE("MLP early stopping: it is repeatable, and off by default") {
  const auto m = matrices(pretraining());
  const auto state = [&](double validation, int seed) {
    const auto classifier = mlp_with({{"validation", validation}, {"patience", 30}, {"committee", 2}});
    classifier->fit(m.inputs, m.targets, static_cast<std::uint64_t>(seed), nullptr);
    return classifier->save();
  };
  CHECK(state(0.25, 1) == state(0.25, 1));
  CHECK(state(0.25, 1) != state(0.0, 1));
  const auto plain = mlp_with({{"committee", 2}});
  plain->fit(m.inputs, m.targets, 1, nullptr);
  CHECK(plain->save() == state(0.0, 1));
}

TEST_SUITE_END();
