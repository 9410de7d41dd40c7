#include "preshape/agent/memory.h"

#include "memory_examples.h"
#include "preshape/base/error.h"
#include "support/data.h"
#include "support/near.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Objects 1 and 2, samples 1 and 2 of object 1, 3 of object 2, 4 of object 1; a state after each sample.
Memory four_samples() {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  learning.add_object(example_object(1)), learning.add_object(example_object(2));
  for (const int object : {1, 1, 2, 1}) {
    learning.store_state(example_state(learning.add_sample(example_sample(object, 7))));
  }
  learning.commit();
  return memory;
}

std::vector<std::int64_t> ids(const std::vector<Sample>& samples) {
  std::vector<std::int64_t> result;
  for (const auto& sample : samples) result.push_back(sample.id);
  return result;
}

}  // namespace

TEST_CASE("Memory: every field of a sample comes back exactly, also from the file") {
  const TemporaryDirectory folder;
  std::vector<Sample> given;
  {
    Memory memory = Memory::open(folder / "m.db", Memory::Mode::kCreate);
    Learning learning = memory.begin_learning();
    learning.add_object(example_object(1));
    for (std::uint64_t seed = 0; seed < 50; ++seed) given.push_back(example_sample(1, seed));
    given[3].inputs = {1e-310,
                       5e-324,
                       1e308,
                       -1e308,
                       0.1,
                       1.0 / 3.0,
                       1,
                       5.0 / 6.0,
                       3,
                       -7,
                       1e15,
                       9.007199254740993e15,
                       1e16,
                       1.7976931348623157e308,
                       2.2250738585072014e-308};
    for (const auto& sample : given) learning.add_sample(sample);
    learning.commit();
  }
  const Memory memory = Memory::open(folder / "m.db", Memory::Mode::kReadOnly);
  const auto samples = memory.samples();
  REQUIRE(samples.size() == given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    CHECK(same(samples[i], given[i]));
    CHECK(samples[i].id == static_cast<std::int64_t>(i) + 1);
    CHECK(samples[i].session == 1);
  }
}

TEST_CASE("Memory: every field of an object comes back exactly, in the order of meeting") {
  Memory memory = Memory::in_memory();
  MemoryObject odd = example_object(2);
  odd.name = "two\nlines, \"quotes\" and \xc3\xa9";
  odd.attributes.kilotriangles = 16.4;
  Learning learning = memory.begin_learning();
  CHECK(learning.add_object(odd));
  CHECK(learning.add_object(example_object(1)));
  learning.commit();
  const auto objects = memory.objects();
  REQUIRE(objects.size() == 2);
  CHECK(objects[0].first_seen == 1);
  CHECK(objects[0].name == odd.name);
  CHECK(objects[0].file == odd.file);
  CHECK(objects[0].extents_m == odd.extents_m);
  CHECK(objects[0].attributes.width_normalised == odd.attributes.width_normalised);
  CHECK(objects[0].attributes.height_normalised == odd.attributes.height_normalised);
  CHECK(objects[0].attributes.depth_normalised == odd.attributes.depth_normalised);
  CHECK(objects[0].attributes.vertices_per_triangle == odd.attributes.vertices_per_triangle);
  CHECK(objects[0].attributes.normals_per_triangle == odd.attributes.normals_per_triangle);
  CHECK(objects[0].attributes.faces_per_triangle == odd.attributes.faces_per_triangle);
  CHECK(objects[0].attributes.kilotriangles == 16.4);
  CHECK(objects[0].first_seen_utc == odd.first_seen_utc);
  CHECK(memory.object(example_hash(1))->first_seen == 2);
  CHECK_FALSE(memory.object(example_hash(3)).has_value());
}

TEST_CASE("Memory: the first record of an object stays") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  MemoryObject again = example_object(1);
  again.name = "another name";
  CHECK_FALSE(learning.add_object(again));
  CHECK(memory.object(again.hash)->name == "object 1");
}

TEST_CASE("Memory: the latest state of a component comes back byte for byte") {
  Memory memory = four_samples();
  const auto state = memory.latest_state("mlp");
  REQUIRE(state.has_value());
  const ClassifierState given = example_state(4);
  CHECK(state->bytes == given.bytes);
  CHECK(state->parameters_json == given.parameters_json);
  CHECK(state->last_sample == 4);
  CHECK(state->seed == given.seed);
  CHECK(state->outcome.status == TrainingOutcome::Status::kArrived);
  CHECK(state->outcome.epochs == 35);
  CHECK(state->outcome.restarts == 2);
  CHECK(state->outcome.mean_squared_error == 9.5e-4);
  CHECK(state->outcome.wrong_rows == 1);
  CHECK_FALSE(memory.latest_state("knn").has_value());
}

TEST_CASE("Memory: of each component only the newest states are kept") {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  ClassifierState other = example_state(0);
  other.component = "knn";
  learning.store_state(other);
  for (int i = 0; i < 20; ++i) learning.store_state(example_state(0));
  learning.commit();
  CHECK(memory.statistics().states == Learning::kStatesKept + 1);
  CHECK(memory.latest_state("knn")->id == 1);
  CHECK(memory.latest_state("mlp")->id == 21);
}

TEST_CASE("Memory: samples can be asked for by what is new and by object") {
  const Memory memory = four_samples();
  CHECK(ids(memory.samples()) == std::vector<std::int64_t>{1, 2, 3, 4});
  CHECK(ids(memory.samples(2)) == std::vector<std::int64_t>{3, 4});
  CHECK(ids(memory.samples_of(example_hash(1))) == std::vector<std::int64_t>{1, 2, 4});
}

TEST_CASE("Learning: without commit nothing of it remains") {
  Memory memory = four_samples();
  {
    Learning learning = memory.begin_learning();
    learning.add_object(example_object(9));
    learning.store_state(example_state(learning.add_sample(example_sample(9, 1))));
    learning.set_note("key", "value");
    CHECK(memory.samples().size() == 5);  // its own rows can be read before commit
  }
  CHECK(memory.samples().size() == 4);
  CHECK(memory.objects().size() == 2);
  CHECK(memory.latest_state("mlp")->last_sample == 4);
  CHECK_FALSE(memory.note("key").has_value());
  CHECK(memory.generation() == 1);
}

TEST_CASE("Learning: ids are never used again, and the generation only grows") {
  Memory memory = four_samples();
  const std::int64_t last = 4;
  {
    Learning learning = memory.begin_learning();
    learning.forget_samples(std::span(&last, 1));
    learning.commit();
  }
  CHECK(memory.generation() == 2);
  Learning learning = memory.begin_learning();
  CHECK(learning.session() == 3);
  CHECK(learning.add_sample(example_sample(1, 1)) == 5);
}

TEST_CASE("Forget: states that learned a forgotten sample go, older ones stay") {
  Memory memory = four_samples();
  const std::int64_t third = 3;
  Learning learning = memory.begin_learning();
  const Forgotten forgotten = learning.forget_samples(std::span(&third, 1));
  learning.commit();
  CHECK(forgotten.samples == 1);
  CHECK(forgotten.states == 2);  // those after samples 3 and 4
  CHECK(memory.latest_state("mlp")->last_sample == 2);
  CHECK(ids(memory.samples()) == std::vector<std::int64_t>{1, 2, 4});
}

TEST_CASE("Forget: an object goes with all its samples and leaves the others") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  const Forgotten forgotten = learning.forget_object(example_hash(1));
  learning.commit();
  CHECK(forgotten.samples == 3);
  CHECK(forgotten.states == 4);
  CHECK(memory.objects().size() == 1);
  CHECK(ids(memory.samples()) == std::vector<std::int64_t>{3});
  CHECK(memory.integrity_faults().empty());
}

TEST_CASE("Forget: what is not there is told, and nothing is forgotten") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  const std::vector<std::int64_t> asked = {1, 77};
  CHECK_THROWS_SAYING(learning.forget_samples(asked), InputError, "has no sample 77 to forget");
  CHECK_THROWS_SAYING(learning.forget_object("abc"), InputError, "has no object 'abc' to forget");
  learning.commit();
  CHECK(memory.samples().size() == 4);
}

TEST_CASE("Learning: a sample needs its object, finite inputs and a target from 1") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  const auto refused = [&](auto change, const char* part) {
    Sample sample = example_sample(1, 1);
    change(sample);
    CHECK_THROWS_SAYING(learning.add_sample(sample), InputError, part);
  };
  refused([](Sample& s) { s.object = example_hash(3); }, "add the object before its samples");
  refused([](Sample& s) { s.object = "xyz"; }, "64 lower-case hex digits, got 'xyz'");
  refused([](Sample& s) { s.inputs[6] = kNaN; }, "input 'stability' must be a finite number, got nan");
  refused([](Sample& s) { s.inputs[14] = kInfinity; }, "'kilotriangles' must be a finite number, got inf");
  refused([](Sample& s) { s.plane = 0; }, "plane must be 1 or more, got 0");
  refused([](Sample& s) { s.symbol = -1; }, "symbol must be 1 or more, got -1");
  refused([](Sample& s) { s.virtual_fingers = 0; }, "virtual_fingers must be 1 or more");
  refused([](Sample& s) { s.approach_m = kNaN; }, "approach_m must be a finite number");
  refused([](Sample& s) { s.score = kInfinity; }, "score must be finite, or NaN where unknown");
  refused([](Sample& s) { s.task = std::string("a\0b", 3); }, "zero byte");
  CHECK(memory.samples().size() == 4);
}

TEST_CASE("Learning: an unknown wrench or score comes back as NaN, minus zero as zero") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  Sample sample = example_sample(1, 1);
  sample.wrench.fill(kNaN);
  sample.score = kNaN;
  sample.inputs[0] = -0.0;
  learning.add_sample(sample);
  const Sample read = memory.samples(4).front();
  CHECK(std::isnan(read.wrench[0]));
  CHECK(std::isnan(read.wrench[5]));
  CHECK(std::isnan(read.score));
  CHECK(read.inputs[0] == 0.0);
  CHECK_FALSE(std::signbit(read.inputs[0]));
}

TEST_CASE("Learning: a state cannot have learned a sample that is not there") {
  Memory memory = four_samples();
  Learning learning = memory.begin_learning();
  CHECK_THROWS_SAYING(learning.store_state(example_state(5)), InputError, "the last one is 4");
  ClassifierState nameless = example_state(1);
  nameless.component.clear();
  CHECK_THROWS_SAYING(learning.store_state(nameless), InputError, "must name its component");
}

TEST_CASE("Learning: an object needs a content hash and finite extents") {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  MemoryObject object = example_object(1);
  object.hash[0] = 'G';
  CHECK_THROWS_SAYING(learning.add_object(object), InputError, "64 lower-case hex digits");
  object = example_object(1);
  object.extents_m[2] = kNaN;
  CHECK_THROWS_SAYING(learning.add_object(object), InputError,
                      "object 'object 1': an extent must be a finite");
}

TEST_CASE("Memory: notes are kept, replaced and removed") {
  Memory memory = Memory::in_memory();
  const auto set = [&](std::string_view value) {
    Learning learning = memory.begin_learning();
    learning.set_note("pretrained with", value);
    learning.commit();
  };
  set("cube"), set("sphere");
  CHECK(memory.note("pretrained with") == "sphere");
  set("");
  CHECK_FALSE(memory.note("pretrained with").has_value());
}

TEST_CASE("Memory: SQL in a text is only text") {
  Memory memory = four_samples();
  const std::string evil = "'); DROP TABLE sample; --";
  Learning learning = memory.begin_learning(evil);
  MemoryObject object = example_object(5);
  object.name = evil;
  learning.add_object(object);
  learning.set_note(evil, evil);
  learning.commit();
  CHECK(memory.object(example_hash(5))->name == evil);
  CHECK(memory.note(evil) == evil);
  CHECK(memory.samples().size() == 4);
}

TEST_CASE("Memory: statistics count what is there") {
  Memory memory = Memory::in_memory();
  Learning learning = memory.begin_learning();
  learning.add_object(example_object(1));
  Sample sample = example_sample(1, 1);
  for (const auto provenance : {Provenance::kPretrain, Provenance::kPretrain, Provenance::kPretrain,
                                Provenance::kWrench, Provenance::kTask, Provenance::kTask}) {
    sample.provenance = provenance;
    learning.add_sample(sample);
  }
  learning.commit();
  const MemoryStatistics statistics = memory.statistics();
  CHECK(statistics.objects == 1);
  CHECK(statistics.pretrain_samples == 3);
  CHECK(statistics.wrench_samples == 1);
  CHECK(statistics.task_samples == 2);
  CHECK(statistics.samples() == 6);
  CHECK(statistics.states == 0);
  CHECK(statistics.sessions == 1);
  CHECK(statistics.schema_version == 1);
  CHECK(statistics.bytes > 0);
}

TEST_SUITE_END();
