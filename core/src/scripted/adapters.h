#pragma once

#include <memory>

#include "blueprint.h"
#include "preshape/plugin/kind.h"

namespace preshape::scripted {

// One adapter a kind: an object of the kind's interface whose answers come from Lua. Each reads the instance
// once to check its keys, and keeps a pool of states for its calls.
// @throws ScriptError "file:line: ..." when the instance is not what its kind asks for

std::shared_ptr<ContactModel> make_contact(Blueprint blueprint);
std::shared_ptr<Similarity> make_similarity(Blueprint blueprint);
std::shared_ptr<Classifier> make_classifier(Blueprint blueprint);
std::shared_ptr<HandModel> make_hand(Blueprint blueprint);
std::shared_ptr<QualityMeasure> make_quality(Blueprint blueprint);
std::shared_ptr<Explorer> make_explorer(Blueprint blueprint);
std::shared_ptr<GraspSimulator> make_simulator(Blueprint blueprint);

}  // namespace preshape::scripted
