#include <algorithm>

#include "preshape/base/error.h"
#include "support/agent.h"
#include "support/near.h"
#include "support/shapes.h"

using namespace preshape;
using namespace preshape::test;

TEST_SUITE_BEGIN("core/agent");

namespace {

const auto kAccept = [] { return true; };
const auto kRefuse = [] { return false; };

std::int64_t count(const Memory& memory, Provenance provenance) {
  const auto samples = memory.samples();
  return std::count_if(samples.begin(), samples.end(), [&](const Sample& s) { return s.provenance == provenance; });
}

/// The best grasp at one station, judged before a task.
JudgedGrasp grasp_at(const Agent& agent, const SensedObject& object, const Task& task, const Station& station) {
  JudgedGrasp judged;
  judged.grasp = agent.analysis.analyser->analyse(object, station);
  REQUIRE(judged.grasp.is_grasp());
  judged.preshape = agent.analysis.analyser->preshape(object, judged.grasp);
  judged.criticism = agent.critic->judge(task.screw, components(judged.grasp.resultant));
  return judged;
}

}  // namespace

TEST_CASE("Pretraining: two stations of each of the twelve planes are taught, and each is recalled") {
  Agent agent;
  const auto cube = agent.shipped("cube");
  const LessonReport report = agent.learning->pretrain(*cube, {}, nullptr);
  CHECK(report.rows_added == 24);
  CHECK(report.training.status == TrainingOutcome::Status::kArrived);
  CHECK(report.training.wrong_rows == 0);
  CHECK(count(*agent.memory, Provenance::kPretrain) == 24);
  for (int plane = 0; plane < 12; ++plane) {
    for (const double x : {-0.25, 0.25}) {
      const auto grasp = agent.analysis.analyser->analyse(*cube, {plane, x, 0});
      const Task own{components(grasp.resultant), grasp.stability, grasp.manipulability, ""};
      const Performance recalled = agent.performance->perform(*cube, own);
      CHECK(recalled.preshape == Preshape{plane + 1, x < 0 ? 3 : 5, 2});
      // The symbol names exactly the station that was taught, so the wrench is the same to the last bit.
      CHECK(recalled.grasp.resultant.vector() == grasp.resultant.vector());
    }
  }
}

TEST_CASE("Pretraining: teaching what is known adds no row") {
  Agent agent;
  agent.pretrain();
  CHECK(agent.pretrain().rows_added == 0);
  CHECK(agent.memory->samples().size() == 24);
}

TEST_CASE("Pretraining: the stations asked for are taught, and no others") {
  Agent agent;
  CHECK(agent.learning->pretrain(*agent.shipped("cube"), {{0.0, 0.65, 0.95}}, nullptr).rows_added == 36);
  for (const Sample& sample : agent.memory->samples()) {
    CHECK((sample.approach_ratio == 0.0 || sample.approach_ratio == 0.65 || sample.approach_ratio == 0.95));
  }
}

TEST_CASE("Pretraining: an object without any grasp is refused, and nothing is remembered of it") {
  Agent::Options options;
  options.analysis.opposition_angle_deg = 0.0;
  Agent agent(options);
  CHECK_THROWS_SAYING(agent.learning->pretrain(*agent.analysis.sense(tetrahedron(), "spike"), {}, nullptr), InputError,
                      "object 'spike' has no grasp at any pretraining station");
  CHECK(agent.memory->objects().empty());
}

TEST_CASE("Recall: a memory that was taught with other planes or symbols is refused with the mend, and stays as it was") {
  auto memory = std::make_shared<Memory>(Memory::in_memory());
  {
    Agent agent({.memory = memory});
    agent.pretrain();
  }
  const auto rows = memory->samples().size();
  auto fewer = thesis_planes();
  fewer.pop_back();
  Agent other({.memory = memory, .planes = fewer});
  CHECK_THROWS_SAYING(other.learning->recall(), InputError, "was taught with other approach planes or symbols (12 planes");
  CHECK_THROWS_SAYING(other.pretrain(), InputError, "give it a memory of its own");
  CHECK(memory->samples().size() == rows);
  Agent same({.memory = memory});
  CHECK_NOTHROW(same.learning->recall());
}

TEST_CASE("Exploring: an explorer's own budget goes before that of learning") {
  Agent agent;
  const auto cube = agent.shipped("cube");
  LearningElement::Parts parts = agent.parts();
  parts.explorer.budget = 17;
  parts.proof.budget = 5;
  const LearningElement learning(parts);
  CHECK(learning.explore(*cube, {{-1, -1, -1, -0.8, -0.8, -0.8}, 6, 5, ""}, nullptr).evaluations <= 22);
}

TEST_CASE("Teaching: wrench, task or both add the grasp's own wrench, the task as asked, or both") {
  using Teach = LearningSettings::Teach;
  for (const auto& [teach, wrenches, tasks] :
       std::vector<std::tuple<Teach, int, int>>{{Teach::kWrench, 1, 0}, {Teach::kTask, 0, 1}, {Teach::kBoth, 1, 1}}) {
    Agent::Options options;
    options.learning.teach = teach;
    Agent agent(options);
    agent.pretrain();
    const auto box = agent.shipped("box");
    const Task task = named_task("T1_2");
    const auto best = agent.learning->explore(*box, task, nullptr).best;
    REQUIRE(best);
    REQUIRE(agent.serves(*best));
    const auto lesson = agent.learning->teach(*box, task, *best, true, kAccept, nullptr);
    CHECK(lesson.accepted);
    CHECK(lesson.report.rows_added == wrenches + tasks);
    CHECK(count(*agent.memory, Provenance::kWrench) == wrenches);
    CHECK(count(*agent.memory, Provenance::kTask) == tasks);
    for (const Sample& sample : agent.memory->samples_of(box->object.hash)) {
      const auto expected = sample.provenance == Provenance::kTask
                                ? make_features(task.screw, task.stability, task.manipulability, box->attributes)
                                : make_features(components(best->grasp.resultant), best->grasp.stability,
                                                best->grasp.manipulability, box->attributes);
      CHECK(sample.inputs == expected);
      CHECK(Preshape{sample.plane, sample.symbol, sample.virtual_fingers} == best->preshape);
      CHECK(sample.approach_ratio == best->grasp.approach_fraction);
      CHECK(sample.score == best->criticism.first);
    }
  }
}

TEST_CASE("Teaching: a task that the grasp does not serve is never taught as if it did") {
  for (const auto teach : {LearningSettings::Teach::kTask, LearningSettings::Teach::kBoth, LearningSettings::Teach::kWrench}) {
    Agent::Options options;
    options.learning.teach = teach;
    Agent agent(options);
    agent.pretrain();
    const auto box = agent.shipped("box");
    const Task task = named_task("T4_1");
    const auto lesson = agent.learning->teach(*box, task, grasp_at(agent, *box, task, {0, 0.25, 0}), false, kAccept, nullptr);
    CHECK(lesson.report.rows_added == 1);
    CHECK(count(*agent.memory, Provenance::kWrench) == 1);
    CHECK(count(*agent.memory, Provenance::kTask) == 0);
  }
}

TEST_CASE("Teaching: a refused lesson leaves memory and classifier as before, though it saw the new classifier") {
  Agent agent;
  agent.pretrain();
  const auto box = agent.shipped("box");
  const Task task = named_task("T1_2");
  const auto best = agent.learning->explore(*box, task, nullptr).best;
  REQUIRE(best);
  const std::string before = agent.classifier->save();
  const auto generation = agent.memory->generation();
  bool recalled_in_lesson = false;
  const auto lesson = agent.learning->teach(*box, task, *best, true, [&] {
    recalled_in_lesson = agent.performance->perform(*box, task).preshape == best->preshape;
    return false;
  }, nullptr);
  CHECK(recalled_in_lesson);
  CHECK_FALSE(lesson.accepted);
  CHECK(agent.classifier->save() == before);
  CHECK(agent.memory->generation() == generation);
  CHECK(agent.memory->samples().size() == 24);
  CHECK_FALSE(agent.memory->object(box->object.hash));
  agent.learning->recall();
  CHECK(agent.classifier->save() == before);
}

TEST_CASE("Teaching: when the examination itself fails, the next recall brings the classifier back to the memory") {
  Agent agent;
  agent.pretrain();
  const auto box = agent.shipped("box");
  const Task task = named_task("T1_2");
  const auto best = agent.learning->explore(*box, task, nullptr).best;
  REQUIRE(best);
  const std::string before = agent.classifier->save();
  CHECK_THROWS_SAYING(agent.learning->teach(*box, task, *best, true, []() -> bool { throw InputError("broken off"); }, nullptr),
                      InputError, "broken off");
  agent.learning->recall();
  CHECK(agent.classifier->save() == before);
  CHECK(agent.memory->samples().size() == 24);
}

TEST_CASE("Teaching: a row with the same question and another answer gives way to the new one; a known row is not repeated") {
  Agent agent;
  agent.pretrain();
  const auto box = agent.shipped("box");
  const Task task = named_task("T1_2");
  const auto first = grasp_at(agent, *box, task, {1, 0.25, 0}), second = grasp_at(agent, *box, task, {3, -0.25, 0});
  agent.learning->teach(*box, task, first, true, kAccept, nullptr);
  const auto before = agent.memory->samples();
  CHECK(agent.learning->teach(*box, task, first, true, kAccept, nullptr).report.rows_added == 0);
  CHECK(agent.memory->samples().size() == before.size());

  CHECK(agent.learning->teach(*box, task, second, true, kAccept, nullptr).report.rows_added == 2);
  std::vector<Sample> asked;
  for (const Sample& sample : agent.memory->samples()) {
    if (sample.provenance == Provenance::kTask) asked.push_back(sample);
  }
  REQUIRE(asked.size() == 1);
  CHECK(asked[0].plane == 4);
  CHECK(count(*agent.memory, Provenance::kWrench) == 2);  // two grasps' own wrenches do not contradict each other
  CHECK(agent.performance->perform(*box, task).preshape == second.preshape);
}

TEST_CASE("Applicable task: the nearest remembered pattern, never a task that was merely asked") {
  Agent agent;
  CHECK_FALSE(agent.learning->applicable_task(named_task("T1_1")));
  agent.pretrain();
  const auto box = agent.shipped("box");
  const Task task = named_task("T1_2");
  const auto best = agent.learning->explore(*box, task, nullptr).best;
  REQUIRE(best);
  agent.learning->teach(*box, task, *best, true, kAccept, nullptr);
  REQUIRE(count(*agent.memory, Provenance::kTask) == 1);
  for (const Task& asked : signed_task_space()) {
    const auto applicable = agent.learning->applicable_task(asked);
    REQUIRE(applicable);
    const Criticism chosen = agent.critic->judge(asked.screw, applicable->screw);
    bool among_patterns = false;
    for (const Sample& sample : agent.memory->samples()) {
      if (sample.provenance == Provenance::kTask) continue;
      std::array<double, 6> screw;
      std::copy_n(sample.inputs.begin(), 6, screw.begin());
      CHECK_FALSE(agent.critic->nearer(agent.critic->judge(asked.screw, screw), chosen));
      among_patterns = among_patterns || (screw == applicable->screw && applicable->stability == doctest::Approx(6.0).epsilon(1e-12));
    }
    CHECK(among_patterns);
  }
}

TEST_CASE("Exploring: the second explorer is asked only when the first finds nothing that serves") {
  Agent agent;
  const auto box = agent.shipped("box");
  int served = 0, unserved = 0;
  for (const Task& task : task_space()) {
    const auto exploration = agent.learning->explore(*box, task, nullptr);
    REQUIRE(exploration.best);
    if (agent.serves(*exploration.best) && exploration.explorer == "beam") {
      CHECK(exploration.evaluations < 12 * 39);
      ++served;
    } else {
      CHECK(exploration.evaluations > 12 * 39);
      ++unserved;
    }
    // The grasp is the station's: its preshape names the plane, and its judgement is of its wrench.
    CHECK(exploration.best->preshape.plane == exploration.best->grasp.plane + 1);
    CHECK(exploration.best->criticism.first ==
          agent.critic->judge(task.screw, components(exploration.best->grasp.resultant)).first);
  }
  CHECK(served > 0);
  CHECK(unserved > 0);
}

TEST_CASE("Nearest task: another task, which a grasp serves, and no nearer one can be served") {
  Agent agent;
  const auto box = agent.shipped("box");
  for (const char* name : {"T4_1", "T4_6-+", "T1_3"}) {
    const Task asked = named_task(name);
    const auto nearest = agent.learning->nearest_servable_task(*box, asked);
    REQUIRE(nearest);
    CHECK(nearest->task.screw != asked.screw);
    CHECK(agent.serves(nearest->grasp));
    const Criticism chosen = agent.critic->judge(asked.screw, nearest->task.screw);
    CHECK(nearest->similarity == chosen.first);
    for (const Task& other : signed_task_space()) {
      if (other.screw == asked.screw || !agent.critic->nearer(agent.critic->judge(asked.screw, other.screw), chosen)) continue;
      const auto best = agent.learning->explore(*box, other, nullptr).best;
      CHECK_FALSE((best && agent.serves(*best)));
    }
  }
}

TEST_CASE("Recall: a state made with other parameters is not used, one of ours is") {
  Agent agent;
  agent.pretrain();
  const auto store = [&](const char* parameters) {
    Learning learning = agent.memory->begin_learning();
    ClassifierState state;
    state.component = "mlp";
    state.parameters_json = parameters;
    state.bytes = "not a state of any classifier";
    state.last_sample = agent.memory->samples().back().id;
    learning.store_state(state);
    learning.commit();
  };
  store("{\"hidden\": 7}");
  agent.learning->recall();
  CHECK(agent.performance->perform(*agent.shipped("cube"), named_task("T1_1")).grasp.is_grasp());
  store("{}");
  CHECK_THROWS_AS(agent.learning->recall(), InputError);
}

TEST_SUITE_END();
