#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "preshape/contact/contact_model.h"
#include "preshape/fuzzy/similarity.h"
#include "preshape/geometry/collision.h"
#include "preshape/grasp/classifier.h"
#include "preshape/grasp/explorer.h"
#include "preshape/grasp/quality.h"
#include "preshape/grasp/simulator.h"
#include "preshape/hand/hand_model.h"

namespace preshape {

/// The kinds of component, in the order in which the analysis meets them.
inline constexpr std::array<std::string_view, 8> kKinds = {"contact", "similarity", "classifier", "collision",
                                                           "hand",    "quality",    "explorer",   "simulator"};

/// Kind name of an interface or of a class that implements one.
template <class T>
constexpr std::string_view kind_of() {
  if constexpr (std::is_base_of_v<ContactModel, T>) return "contact";
  if constexpr (std::is_base_of_v<Similarity, T>) return "similarity";
  if constexpr (std::is_base_of_v<Classifier, T>) return "classifier";
  if constexpr (std::is_base_of_v<CollisionBackend, T>) return "collision";
  if constexpr (std::is_base_of_v<HandModel, T>) return "hand";
  if constexpr (std::is_base_of_v<QualityMeasure, T>) return "quality";
  if constexpr (std::is_base_of_v<Explorer, T>) return "explorer";
  if constexpr (std::is_base_of_v<GraspSimulator, T>) return "simulator";
  return "";
}

namespace detail {
template <class T, class... Interfaces>
struct FirstBase;
template <class T, class First, class... Rest>
struct FirstBase<T, First, Rest...>
    : std::conditional_t<std::is_base_of_v<First, T>, std::type_identity<First>, FirstBase<T, Rest...>> {};
template <class T>
struct FirstBase<T> {};
}  // namespace detail

/// The interface that a component class implements.
template <class T>
using InterfaceOf = typename detail::FirstBase<T, ContactModel, Similarity, Classifier, CollisionBackend, HandModel,
                                               QualityMeasure, Explorer, GraspSimulator>::type;

}  // namespace preshape
