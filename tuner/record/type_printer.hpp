#pragma once
// Prints C++ types as TypeScript interfaces, for code that reads the JSON of their objects. The members of
// the types are declared as in declaration.hpp.

#include <set>
#include <string>

#include "tuner/record/declaration.hpp"

namespace armtune::internal::record {

/// A printer of interfaces. It prints each interface once, and the interfaces of a type's members before the
/// interface of the type itself.
class TypePrinter {
 public:
  /// Returns the TypeScript type of a value. If the type is declared, prints its interface first.
  template <typename T>
  std::string type_of(bool or_null = false);

  const std::string& text() const { return text_; }

 private:
  class Interface;

  std::string text_;
  std::set<std::string> printed_;
};

/// A visitor that collects the members that `declare` visits.
class TypePrinter::Interface {
 public:
  explicit Interface(TypePrinter& printer) : printer_(printer) {}

  Interface& type(const char* name, const std::string& meaning = "") {
    name_ = name;
    text_ = "\n" + comment("/** ", meaning) + "export interface " + name + " {\n";
    return *this;
  }
  template <typename T>
  Interface& operator()(const char* key, const T&, const char* meaning = "",
                        Presence presence = Presence::kAlways) {
    std::string type = printer_.type_of<T>(presence == Presence::kOrNull);
    if constexpr (Optional<T>) {
      if (presence == Presence::kIfAny) type = printer_.type_of<typename T::value_type>();
    }
    return add(key, type, meaning, presence);
  }
  template <typename T>
  Interface& operator()(const char* key, const T&, Words words, const char* meaning = "",
                        Presence presence = Presence::kAlways) {
    return add(key, one_of({words.begin(), words.end()}), meaning, presence);
  }

  static std::string one_of(const std::vector<std::string>& words) {
    std::string type;
    for (const std::string& word : words) type += (type.empty() ? "\"" : " | \"") + word + '"';
    return type;
  }

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }

 private:
  static std::string comment(const char* begin, const std::string& meaning) {
    return meaning.empty() ? meaning : begin + meaning + " */\n";
  }
  Interface& add(const std::string& key, const std::string& type, const char* meaning, Presence presence) {
    text_ += comment("  /** ", meaning) + "  " + key + (presence == Presence::kIfAny ? "?: " : ": ") + type +
             ";\n";
    return *this;
  }

  TypePrinter& printer_;
  std::string name_;
  std::string text_;
};

template <typename T>
std::string TypePrinter::type_of(bool or_null) {
  if constexpr (std::is_enum_v<T>) {
    return Interface::one_of(names_of<T>());
  } else if constexpr (std::is_same_v<T, bool>) {
    return "boolean";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return or_null ? "number | null" : "number";
  } else if constexpr (Text<T>) {
    return "string";
  } else if constexpr (Optional<T>) {
    return type_of<typename T::value_type>() + " | null";
  } else if constexpr (Vector<T>) {
    return "Vec3";
  } else if constexpr (Quaternion<T>) {
    return "Quaternion";
  } else if constexpr (List<T>) {
    const std::string type = type_of<typename T::value_type>(or_null);
    return (type.find('|') == std::string::npos ? type : '(' + type + ')') + "[]";
  } else if constexpr (Pair<T>) {
    return '[' + type_of<typename T::first_type>() + ", " + type_of<typename T::second_type>() + ']';
  } else {
    const T value{};
    Interface fields(*this);
    declare(fields, value);
    if (printed_.insert(fields.name()).second) text_ += fields.text() + "}\n";
    return fields.name();
  }
}

}  // namespace armtune::internal::record
