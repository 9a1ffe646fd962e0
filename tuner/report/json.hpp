#pragma once
// JSON text that may stand inside an HTML page: `<` is written as `\u003c`, so that nothing in it ends a
// script element or begins a comment.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::report {

/// Values go to the array or, after `key`, the object that was begun last.
class Json {
 public:
  void begin_object();
  void end_object();
  void begin_array();
  void end_array();
  void key(std::string_view name);

  /// Reads back to the same bits; null if it is NaN or infinite.
  void number(double value);
  void integer(long value);
  void boolean(bool value);
  void text(std::string_view value);
  void null();
  void texts(const std::vector<std::string>& values);
  void numbers(const std::vector<double>& values);

  /// key and value of an object.
  void number(std::string_view name, double value);
  void number(std::string_view name, const std::optional<double>& value);  ///< null where there is none
  void integer(std::string_view name, long value);
  void boolean(std::string_view name, bool value);
  void text(std::string_view name, std::string_view value);
  void texts(std::string_view name, const std::vector<std::string>& values);
  void numbers(std::string_view name, const std::vector<double>& values);

  const std::string& str() const { return text_; }
  std::string take() { return std::move(text_); }

 private:
  void separate();

  std::string text_;
  bool first_ = true;  ///< the next value or key is the first of its container, or follows its key
};

/// A string as JSON, quotes included. Bytes above 0x7f are kept as they are.
std::string json_quoted(std::string_view text);

}  // namespace armtune::report
