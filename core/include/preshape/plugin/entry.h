#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preshape/base/error.h"
#include "preshape/base/parameters.h"
#include "preshape/plugin/kind.h"
#include "preshape/plugin/manifest.h"

// What a plugin's author needs. A plugin is one class per component and one macro:
//
//   class HardFinger final : public preshape::ContactModel {
//    public:
//     static std::vector<preshape::ParameterDeclaration> parameters();
//     explicit HardFinger(const preshape::Parameters& parameters);
//     ...
//   };
//   PRESHAPE_PLUGIN(({"hard_finger", "1.0.0", "BSD-3-Clause", "A. Author", "Point contact with friction"}),
//                   ({"contact/hard_finger"}),
//                   preshape::component<HardFinger>("hard_finger", "Point contact with Coulomb friction"))

namespace preshape {

/// One component of a library, as its author declares it.
struct ComponentDeclaration {
  std::string kind;
  std::string name;
  std::string summary;                    ///< one line
  std::vector<std::string> capabilities;  ///< promises that the conformance suite holds it to
  std::vector<ParameterDeclaration> parameters;
};

/// How creating a component failed.
enum class CreateError : std::int32_t { kNone, kInput, kOther };

/// A declared component with its maker.
struct ComponentBinding {
  ComponentDeclaration declaration;
  void* (*create)(const Parameters&);
  void (*destroy)(void*) noexcept;
};

/// The table behind a library's one exported symbol.
/// All functions: any thread. Grows at the end; `size` tells how much of it a library has.
struct PluginEntry {
  std::uint32_t size;
  const Manifest* manifest;
  /// The library's declarations; they live as long as the library is loaded.
  const ComponentBinding* (*components)(std::uint32_t* count) noexcept;
  /// A new component as a pointer to its kind's interface, or null with the reason in `error`.
  void* (*create)(std::uint32_t index, const Parameters* parameters, CreateError* status, char* error,
                  std::size_t capacity) noexcept;
  void (*destroy)(std::uint32_t index, void* component) noexcept;
  /// Growth: a library-wide extension by id, or null.
  const void* (*extension)(const char* id) noexcept;
};

namespace detail {

template <class T>
concept DeclaresParameters = requires { T::parameters(); };
template <class T>
concept DeclaresCapabilities = requires { T::capabilities(); };

inline void copy_error(const char* text, char* error, std::size_t capacity) noexcept {
  if (capacity == 0) return;
  std::size_t i = 0;
  for (; i + 1 < capacity && text[i] != '\0'; ++i) error[i] = text[i];
  error[i] = '\0';
}

inline void* create_component(const std::vector<ComponentBinding>& bindings, std::uint32_t index,
                              const Parameters& parameters, CreateError* status, char* error,
                              std::size_t capacity) noexcept {
  try {
    *status = CreateError::kNone;
    if (index < bindings.size()) return bindings[index].create(parameters);
    *status = CreateError::kOther;
    copy_error("the library has no component of that number", error, capacity);
  } catch (const InputError& problem) {
    *status = CreateError::kInput;
    copy_error(problem.what(), error, capacity);
  } catch (const std::exception& problem) {
    *status = CreateError::kOther;
    copy_error(problem.what(), error, capacity);
  } catch (...) {
    *status = CreateError::kOther;
    copy_error("an exception that is no std::exception", error, capacity);
  }
  return nullptr;
}

}  // namespace detail

/// Declares a component: T derives from its kind's interface, is made from `const Parameters&`, and may have
/// static `parameters()` and `capabilities()`.
template <class T>
ComponentBinding component(std::string name, std::string summary) {
  using Interface = InterfaceOf<T>;
  ComponentBinding binding;
  binding.declaration.kind = std::string(kind_of<T>());
  binding.declaration.name = std::move(name);
  binding.declaration.summary = std::move(summary);
  if constexpr (detail::DeclaresParameters<T>) binding.declaration.parameters = T::parameters();
  if constexpr (detail::DeclaresCapabilities<T>) binding.declaration.capabilities = T::capabilities();
  binding.create = [](const Parameters& parameters) -> void* {
    return static_cast<void*>(static_cast<Interface*>(new T(parameters)));
  };
  binding.destroy = [](void* object) noexcept { delete static_cast<Interface*>(object); };
  return binding;
}

}  // namespace preshape

#define PRESHAPE_DETAIL_STRIP(...) __VA_ARGS__

/// Defines the library's manifest and its one exported symbol. `identity` and `component_names` stand in
/// parentheses; what follows are preshape::component<T>(...) in the order of the names.
#define PRESHAPE_PLUGIN(identity, component_names, ...)                                                            \
  namespace {                                                                                                      \
  [[gnu::section("preshape"), gnu::used]] constexpr ::preshape::Manifest preshape_manifest =                       \
      ::preshape::make_manifest(PRESHAPE_DETAIL_STRIP identity, PRESHAPE_DETAIL_STRIP component_names);            \
  const std::vector<::preshape::ComponentBinding>& preshape_bindings() {                                           \
    static const std::vector<::preshape::ComponentBinding> bindings = {__VA_ARGS__};                               \
    return bindings;                                                                                               \
  }                                                                                                                \
  }                                                                                                                \
  extern "C" {                                                                                                     \
  [[gnu::visibility("default")]] extern const ::preshape::PluginEntry preshape_entry;                              \
  }                                                                                                                \
  const ::preshape::PluginEntry preshape_entry = {                                                                 \
      sizeof(::preshape::PluginEntry), &preshape_manifest,                                                         \
      [](std::uint32_t* count) noexcept -> const ::preshape::ComponentBinding* {                                   \
        *count = static_cast<std::uint32_t>(preshape_bindings().size());                                           \
        return preshape_bindings().data();                                                                         \
      },                                                                                                           \
      [](std::uint32_t index, const ::preshape::Parameters* parameters, ::preshape::CreateError* status,           \
         char* error, std::size_t capacity) noexcept -> void* {                                                    \
        return ::preshape::detail::create_component(preshape_bindings(), index, *parameters, status, error,        \
                                                    capacity);                                                     \
      },                                                                                                           \
      [](std::uint32_t index, void* object) noexcept { preshape_bindings()[index].destroy(object); },              \
      [](const char*) noexcept -> const void* { return nullptr; }};
