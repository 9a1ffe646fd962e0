#include "tuner/journal/record.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

std::string joined(const double* begin, const double* end) {
  std::string text;
  for (const double* v = begin; v != end; ++v) text += fmt::format("{}{}", text.empty() ? "" : " ", *v);
  return text;
}

/// Reads a line field by field.
class Fields {
 public:
  explicit Fields(std::string_view line) : rest_(line) {}

  bool more() const { return more_; }

  std::string_view next(const char* what) {
    if (!more_) throw std::invalid_argument(fmt::format("it ends before its {}", what));
    const std::size_t tab = rest_.find('\t');
    const std::string_view field = rest_.substr(0, tab);
    more_ = tab != std::string_view::npos;
    rest_ = more_ ? rest_.substr(tab + 1) : std::string_view();
    return field;
  }

  template <typename T>
  T number(const char* what) {
    const std::string_view field = next(what);
    T value{};
    const char* end = field.data() + field.size();
    if (field.empty() || std::from_chars(field.data(), end, value).ptr != end) {
      throw std::invalid_argument(fmt::format("its {} {} is not a number", what, shown(field)));
    }
    return value;
  }

  std::vector<double> numbers(const char* what) {
    const std::string_view field = next(what);
    std::vector<double> values;
    const char* at = field.data();
    const char* end = at + field.size();
    while (at != end) {
      double value = 0.0;
      const auto [after, error] = std::from_chars(at, end, value);
      if (error != std::errc() || (after != end && *after != ' ')) {
        throw std::invalid_argument(fmt::format("its {} contain a value that is not a number", what));
      }
      values.push_back(value);
      at = after == end ? end : after + 1;
    }
    return values;
  }

 private:
  std::string_view rest_;
  bool more_ = true;
};

}  // namespace

std::string escaped(std::string_view text) {
  std::string word;
  for (const char c : text) {
    switch (c) {
      case '\\':
        word += "\\\\";
        break;
      case '\n':
        word += "\\n";
        break;
      case '\t':
        word += "\\t";
        break;
      case '\0':
        word += "\\0";
        break;
      default:
        word += c;
    }
  }
  return word;
}

std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain += text[i];
      continue;
    }
    const char c = text[++i];
    plain += c == 'n' ? '\n' : c == 't' ? '\t' : c == '0' ? '\0' : c;
  }
  return plain;
}

std::string to_line(const JournalRecord& record) {
  std::string line =
      fmt::format("{}\t{}\t{:.3f}\t{}\t{}", record.number, escaped(record.phase), record.seconds,
                  joined(record.x.data(), record.x.data() + record.x.size()), record.results.size());
  for (const RolloutResult& r : record.results) {
    const auto& values = r.metrics.value;
    line +=
        fmt::format("\t{}\t{}\t{}\t{}\t{}", static_cast<int>(r.status), r.end_time, escaped(r.reason),
                    escaped(r.metrics.max_ratio_joint), joined(values.data(), values.data() + values.size()));
  }
  return line;
}

JournalRecord record_from_line(std::string_view line) {
  Fields fields(line);
  JournalRecord record;
  record.number = fields.number<std::uint64_t>("number");
  record.phase = unescaped(fields.next("phase"));
  record.seconds = fields.number<double>("time");
  record.x = fields.numbers("search coordinates");
  const auto count = fields.number<std::size_t>("number of scenarios");
  while (fields.more()) {
    RolloutResult& r = record.results.emplace_back();
    const int status = fields.number<int>("status");
    r.status = static_cast<RolloutStatus>(status);
    if (status < 0 || std::string_view(name(r.status)).empty()) {
      throw std::invalid_argument(fmt::format("unknown status {}", status));
    }
    r.end_time = fields.number<double>("end time");
    r.reason = unescaped(fields.next("reason"));
    r.metrics.max_ratio_joint = unescaped(fields.next("joint"));
    const std::vector<double> values = fields.numbers("metrics");
    if (values.size() != r.metrics.value.size()) {
      throw std::invalid_argument(
          fmt::format("it has {} metrics; expected {}", values.size(), r.metrics.value.size()));
    }
    std::copy(values.begin(), values.end(), r.metrics.value.begin());
  }
  if (record.results.size() != count) {
    throw std::invalid_argument(
        fmt::format("it has {} scenarios; expected {}", record.results.size(), count));
  }
  return record;
}

}  // namespace armtune::internal
