#pragma once
// Declares the members of types that are stored as JSON. Each type has one function `declare`, which names
// each member with its value and its meaning. Three visitors use this function. JsonWriter writes a value as
// JSON text. JsonReader reads it back. TypePrinter prints the interface for TypeScript code that reads the
// text.
//
//   struct Sample {
//     long number = 0;
//     std::string text;
//     static void declare(auto& f, auto& sample) {
//       f.type("Sample", "A sample that breaks a limit.")("number", sample.number);
//       f("text", sample.text, "What it breaks.", Presence::kIfAny);
//     }
//   };
//
// A member can be a number, a boolean, a text, an enumeration with a function `name`, a spatial vector, a
// quaternion (w, x, y, z), or a type that is declared in the same way. It can also be a list, a pair or an
// optional value of these. Two kinds of members need a list of words, given directly after the value: a text
// that must be one of a few words, and a boolean that is stored as one of two words.

#include <concepts>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace armtune::internal::record {

/// The rule for writing a member into its object.
enum class Presence {
  kAlways,
  kIfAny,   ///< left out if it is empty
  kOrNull,  ///< NaN and infinity become null, also in lists; such a member is never read back
  kLater    ///< always written, but may be missing in files of older versions
};

using Words = std::initializer_list<const char*>;

/// A constraint for a function `declare` that is defined outside its type. It holds if T is `Type` or
/// `const Type`.
template <typename T, typename Type>
concept Of = std::same_as<std::remove_const_t<T>, Type>;

/// Visits the members of a type that has its own static function `declare`.
template <typename Fields, typename T>
requires requires(Fields& f, T& value) {
  std::remove_const_t<T>::declare(f, value);
}
void declare(Fields& f, T& value) {
  std::remove_const_t<T>::declare(f, value);
}

/// Returns the names of an enumeration whose values are 0, 1, 2 and so on.
template <typename Enum>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  for (int i = 0; *name(static_cast<Enum>(i)) != '\0'; ++i) names.emplace_back(name(static_cast<Enum>(i)));
  return names;
}

template <typename T>
concept Text = std::is_convertible_v<const T&, std::string_view>;
template <typename T>
concept Optional = requires(const T& value) {
  value.has_value();
};
template <typename T>
concept Pair = requires(const T& value) {
  value.second;
};
template <typename T>
concept Quaternion = requires(const T& value) {
  value.vec();
};
template <typename T>
concept List = !Text<T> && requires(const T& value) {
  value.begin();
};
/// A list whose length is fixed by its type.
template <typename T>
concept Vector = List<T> && requires(const T& value) {
  T::RowsAtCompileTime;
};

/// True for an empty text or list, and for an optional value that is missing.
template <typename T>
bool is_empty(const T& value) {
  if constexpr (Text<T>) return std::string_view(value).empty();
  if constexpr (Optional<T>) return !value.has_value();
  if constexpr (requires { value.size(); }) return value.size() == 0;
  return false;
}

}  // namespace armtune::internal::record
