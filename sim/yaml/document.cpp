#include "sim/yaml/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <unordered_map>

#include "core/common/error.hpp"

namespace armtune::yaml {
namespace {

constexpr std::string_view kCoreTags = "tag:yaml.org,2002:";

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

/// Escapes line breaks and other control characters, so that a message stays one line.
std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
    } else if (is_control(c)) {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      out += c;
    }
  }
  return out;
}

/// A value as a message shows it: in quotes, cut when long, never in the middle of a UTF-8 character.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  if (text.size() <= kLongest) return fmt::format("'{}'", text);
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return fmt::format("'{}...'", text.substr(0, end));
}

[[noreturn]] void fail_at(const std::string& file, int line, std::string_view key_path,
                          std::string_view what) {
  const std::string key = key_path.empty() ? std::string() : fmt::format("key '{}': ", key_path);
  throw InputError(one_line(fmt::format("{}:{}: {}{}", file, line, key, what)));
}

/// std::from_chars over all of `text`, with the '+' that it does not know: no locale, no octal, no spaces.
template <typename T>
std::errc convert(std::string_view text, T& value) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  const char* const first = text.data() + (plus ? 1 : 0);
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  return end == last || error == std::errc::invalid_argument ? error : std::errc::invalid_argument;
}

/// The digits of an integer with leading zeros, without those zeros; empty for any other text.
std::string without_leading_zeros(std::string_view text) {
  const bool sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  const std::string_view digits = text.substr(sign ? 1 : 0);
  const bool is_integer = digits.find_first_not_of("0123456789") == std::string_view::npos;
  if (!is_integer || digits.size() < 2 || digits[0] != '0') return {};
  const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
  return fmt::format("{}{}", text[0] == '-' ? "-" : "", digits.substr(first));
}

void refuse_leading_zeros(const Node& node, std::string_view text) {
  const std::string decimal = without_leading_zeros(text);
  if (decimal.empty()) return;
  node.fail(fmt::format("{} has a leading zero, octal to some YAML readers and decimal to others; write {}",
                        shown(text), decimal));
}

}  // namespace

void Node::fail(const std::string& what) const {
  fail_at(*file_, line_, key_path_, what);
}

std::string Node::description() const {
  switch (kind_) {
    case Kind::kNull:
      return "the value is empty";
    case Kind::kSequence:
      return fmt::format("the value is a list of {}", items_.size());
    case Kind::kMap:
      return "the value is a map";
    case Kind::kScalar:
      break;
  }
  return is_text_ ? fmt::format("{} is a quoted text", shown(text_))
                  : fmt::format("the value is {}", shown(text_));
}

const std::string& Node::plain_text(const std::string& expected) const {
  if (kind_ != Kind::kScalar) fail(fmt::format("{}; expected {}", description(), expected));
  if (is_text_) fail(fmt::format("{}; expected {}, without quotes", description(), expected));
  return text_;
}

std::string Node::as_string() const {
  if (kind_ != Kind::kScalar) fail(description() + "; expected a text");
  double number = 0.0;
  const bool is_number = convert(text_, number) == std::errc() && std::isfinite(number);
  if (!is_text_ && (is_number || text_ == "true" || text_ == "false")) {
    fail(fmt::format("{0} is a {1}; expected a text: to mean one, put it in quotes, \"{2}\"", shown(text_),
                     is_number ? "number" : "boolean", text_));
  }
  return text_;
}

double Node::as_number() const {
  const std::string& text = plain_text("a number");
  refuse_leading_zeros(*this, text);
  double value = 0.0;
  const std::errc error = convert(text, value);
  if (error == std::errc::result_out_of_range) {
    fail(shown(text) + " does not fit a double; expected a magnitude from 1e-307 to 1e308, or 0");
  }
  if (error != std::errc()) {
    fail(shown(text) +
         " is not a number; expected a decimal number with '.' and no unit, such as -1.5 or 1e3");
  }
  if (!std::isfinite(value)) fail(shown(text) + " is not finite; expected a finite number");
  return value;
}

long Node::as_integer() const {
  const std::string& text = plain_text("an integer");
  refuse_leading_zeros(*this, text);
  long value = 0;
  const std::errc error = convert(text, value);
  if (error == std::errc::result_out_of_range)
    fail(shown(text) + " does not fit 64 bit; expected a smaller integer");
  if (error != std::errc()) {
    fail(shown(text) + " is not an integer; expected decimal digits only, without point, exponent or unit");
  }
  return value;
}

bool Node::as_boolean() const {
  const std::string& text = plain_text("true or false");
  if (text == "true") return true;
  if (text == "false") return false;
  for (const auto& [meant, spellings] : {std::pair("true", " yes Yes YES on On ON y Y True TRUE 1 "),
                                         std::pair("false", " no No NO off Off OFF n N False FALSE 0 ")}) {
    if (std::string_view(spellings).find(" " + text + " ") != std::string_view::npos) {
      fail(fmt::format("{} is not a boolean here; write {}", shown(text), meant));
    }
  }
  fail(shown(text) + " is not a boolean; expected true or false");
}

std::vector<double> Node::as_numbers() const {
  std::vector<double> values;
  if (kind_ != Kind::kSequence) fail(description() + "; expected a list of numbers, such as [1.0, 2.5]");
  for (const Node& item : items_) values.push_back(item.as_number());
  return values;
}

std::vector<double> Node::as_numbers(std::size_t count) const {
  if (kind_ != Kind::kSequence) fail(fmt::format("{}; expected a list of {} numbers", description(), count));
  if (items_.size() != count) {
    fail(fmt::format("the list has {} entries; expected {} numbers", items_.size(), count));
  }
  return as_numbers();
}

std::vector<std::string> Node::as_strings() const {
  std::vector<std::string> values;
  if (kind_ != Kind::kSequence) fail(description() + "; expected a list of texts, such as [left, right]");
  for (const Node& item : items_) values.push_back(item.as_string());
  return values;
}

const std::vector<Node>& Node::items() const {
  if (kind_ != Kind::kSequence) fail(description() + "; expected a list");
  return items_;
}

const std::vector<std::pair<std::string, Node>>& Node::entries() const {
  if (kind_ == Kind::kMap) return entries_;
  // 'mass:5' is one plain scalar to YAML, and the most common way to lose a map.
  const bool no_space = kind_ == Kind::kScalar && !is_text_ && text_.find(':') != std::string::npos;
  fail(fmt::format("{}; expected a map of 'key: value'{}", description(),
                   no_space ? ", with a space after the colon" : ""));
}

const Node* Node::find(std::string_view key) const {
  const auto& all = entries();
  const auto entry = std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.first == key; });
  return entry == all.end() ? nullptr : &entry->second;
}

/// Builds our tree from yaml-cpp's events and refuses at the first event that should not be: nothing is ever
/// expanded, so an alias bomb or a huge list costs no more than its first offending item.
class TreeBuilder final : public YAML::EventHandler {
 public:
  /// `text` outlives the builder; it is what yaml-cpp's marks point into.
  TreeBuilder(std::string_view text, std::shared_ptr<const std::string> file)
      : text_(text), file_(std::move(file)) {}

  std::optional<Node> take_root() { return std::move(root_); }

  /// An error of yaml-cpp itself, in our words where its own mislead.
  [[noreturn]] void fail_syntax(const YAML::Exception& error) const {
    const int line = std::max(error.mark.line, 0) + 1;
    if (error.msg.starts_with(YAML::ErrorMsg::UNKNOWN_ANCHOR)) refuse_alias(line);
    std::string what = "not valid YAML: " + error.msg;
    const bool unclosed =
        error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW;
    if (unclosed && !open_.empty()) what += fmt::format("; opened on line {}", open_.back().node.line_);
    fail_at(*file_, line, {}, what);
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 1) return;
    const bool marker = rest_at(mark).starts_with("---");
    fail_at(*file_, line_of(mark), {},
            marker ? "a second document starts here; expected one document in a file"
                   : "text after the end of the document; check the indentation of this line");
  }
  void OnDocumentEnd() override {
    if (!container_key_) return;
    fail_at(*file_, container_key_->first, container_key_->second,
            "a key is a list or a map; expected a text before ':'");
  }

  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    fail_at(
        *file_, line_of(mark), next_path(),
        fmt::format("anchor {}: anchors and aliases are not accepted; write the value out where it is used",
                    shown("&" + name)));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse_alias(line_of(mark)); }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (expects_key())
      fail_at(*file_, line_of(mark), parent_path(), "a key is empty; expected a text before ':'");
    Node node = start(mark, Node::Kind::kNull);
    if (!open_.empty() && open_.back().node.kind_ == Node::Kind::kSequence) node.line_ = line_of_null(mark);
    attach(std::move(node));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    check_quotes(mark);
    check_tag(mark, tag, {"str", "int", "float", "bool", "null"});
    if (expects_key()) return take_key(mark, value);
    Node node = start(mark, Node::Kind::kScalar);
    node.text_ = value;
    node.is_text_ = tag == "!" || tag == std::string(kCoreTags) + "str";
    if (tag == std::string(kCoreTags) + "null") {
      if (!value.empty() && value != "~" && value != "null")
        node.fail(shown(value) + " is tagged !!null; remove the tag");
      node.kind_ = Node::Kind::kNull;
    }
    attach(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    check_tag(mark, tag, {"seq"});
    open(mark, Node::Kind::kSequence);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    check_tag(mark, tag, {"map"});
    open(mark, Node::Kind::kMap);
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map whose end has not come yet.
  struct Open {
    Node node;
    std::optional<std::string> key;  ///< of the value that comes next, in a map
    int key_line = 0;                ///< where that key is
    /// Line of every key so far: a hash, so that a large map is not quadratic.
    std::unordered_map<std::string, int> key_lines;
    bool is_key = false;  ///< stands where a map has its key
  };

  static int line_of(const YAML::Mark& mark) { return mark.line + 1; }
  std::string_view rest_at(const YAML::Mark& mark) const {
    return text_.substr(std::min(text_.size(), static_cast<std::size_t>(std::max(mark.pos, 0))));
  }

  bool expects_key() const {
    return !open_.empty() && open_.back().node.kind_ == Node::Kind::kMap && !open_.back().key;
  }
  std::string parent_path() const { return open_.empty() ? std::string() : open_.back().node.key_path_; }
  std::string next_path() const {
    if (open_.empty() || expects_key()) return parent_path();
    const Open& parent = open_.back();
    const std::string own = parent.key ? *parent.key : std::to_string(parent.node.items_.size());
    return parent.node.key_path_.empty() ? own : parent.node.key_path_ + "/" + own;
  }

  Node start(const YAML::Mark& mark, Node::Kind kind) {
    Node node;
    node.kind_ = kind;
    node.file_ = file_;
    node.key_path_ = next_path();
    node.line_ = !open_.empty() && open_.back().key ? open_.back().key_line : line_of(mark);
    // Every value holds its path: without a limit, one long key above a long list would fill the memory.
    if (node.key_path_.size() > kMaxPathBytes) {
      fail_at(*file_, node.line_, {},
              fmt::format("the keys down to here are longer than {} bytes", kMaxPathBytes));
    }
    if (++item_count_ > kMaxItems) {
      fail_at(*file_, node.line_, {},
              fmt::format("more than {} values; expected fewer in one file", kMaxItems));
    }
    return node;
  }

  void attach(Node node) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.key) {
      parent.node.entries_.emplace_back(std::move(*parent.key), std::move(node));
      parent.key.reset();
    } else {
      parent.node.items_.push_back(std::move(node));
    }
  }

  void open(const YAML::Mark& mark, Node::Kind kind) {
    if (open_.size() == kMaxDepth) {
      fail_at(*file_, line_of(mark), {}, fmt::format("nested more than {} levels deep", kMaxDepth));
    }
    const bool is_key = expects_key();
    if (is_key && !container_key_) container_key_ = {line_of(mark), parent_path()};
    open_.push_back({start(mark, kind), {}, 0, {}, is_key});
  }

  void close() {
    const bool is_key = open_.back().is_key;
    Node node = std::move(open_.back().node);
    open_.pop_back();
    if (is_key) {
      open_.back().key.emplace();  // only until the document ends and is refused
    } else {
      attach(std::move(node));
    }
  }

  void take_key(const YAML::Mark& mark, const std::string& key) {
    Open& map = open_.back();
    if (key.size() > kMaxKeyBytes) {
      fail_at(*file_, line_of(mark), parent_path(),
              fmt::format("key {} has {} bytes; expected at most {}", shown(key), key.size(), kMaxKeyBytes));
    }
    const auto [first, is_new] = map.key_lines.emplace(key, line_of(mark));
    map.key = key;
    map.key_line = line_of(mark);
    if (!is_new) {
      fail_at(*file_, line_of(mark), next_path(),
              fmt::format("duplicate key, already on line {}; remove one of the two", first->second));
    }
  }

  [[noreturn]] void refuse_alias(int line) const {
    fail_at(*file_, line, next_path(),
            "aliases (*name) are not accepted; write the value out, or put a text that begins with '*' in "
            "quotes");
  }

  void check_tag(const YAML::Mark& mark, const std::string& tag,
                 std::initializer_list<std::string_view> core) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    for (const std::string_view name : core) {
      if (tag == std::string(kCoreTags).append(name)) return;
    }
    fail_at(*file_, line_of(mark), next_path(),
            fmt::format("tag {} is not accepted here; remove it", shown(tag)));
  }

  /// yaml-cpp takes the end of the text for the closing quote; the rest of the file would silently become
  /// part of the string, and its keys would get their defaults.
  void check_quotes(const YAML::Mark& mark) const {
    std::string_view rest = rest_at(mark);
    if (rest.starts_with('!')) {
      rest.remove_prefix(std::min(rest.find_first_of(" \t\r\n"), rest.size()));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    }
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) return;
    const char quote = rest[0];
    for (std::size_t i = 1; i < rest.size(); ++i) {
      if (quote == '"' && rest[i] == '\\') {
        ++i;
      } else if (rest[i] == quote) {
        if (quote == '"' || i + 1 == rest.size() || rest[i + 1] != quote) return;
        ++i;
      }
    }
    fail_at(*file_, line_of(mark), next_path(),
            fmt::format("the quote {} opened here is never closed", quote));
  }

  /// Line of an empty list element: yaml-cpp marks it at whatever comes after it.
  int line_of_null(const YAML::Mark& mark) const {
    for (const std::string_view word : {"~", "null", "Null", "NULL"}) {
      if (rest_at(mark).starts_with(word)) return line_of(mark);
    }
    const std::string_view before = text_.substr(0, text_.size() - rest_at(mark).size());
    const std::size_t last = std::min(before.find_last_not_of(" \t\r\n"), before.size());
    const auto breaks = std::count(before.begin() + static_cast<std::ptrdiff_t>(last), before.end(), '\n');
    return std::max(1, line_of(mark) - static_cast<int>(breaks));
  }

  std::string_view text_;
  std::shared_ptr<const std::string> file_;
  std::vector<Open> open_;
  std::optional<Node> root_;
  /// Line and parent of the first key that is a list or a map. Refused only at the end of the document: a
  /// bracket that is never closed looks like one until then, and deserves its own message.
  std::optional<std::pair<int, std::string>> container_key_;
  std::size_t item_count_ = 0;
  int documents_ = 0;
};

namespace {

/// yaml-cpp ends a file at \x04 without a word, keeps NUL in values and guesses UTF-16.
void check_characters(std::string_view text, const std::string& file) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    throw InputError(one_line(file + ": the text is UTF-16; save it as UTF-8"));
  }
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (!is_control(c) || c == '\n' || c == '\r' || c == '\t') continue;
    fail_at(file, line, {},
            fmt::format("control character 0x{:02x}; expected text in UTF-8", static_cast<unsigned>(c)));
  }
}

[[noreturn]] void fail_too_large(const std::string& file) {
  throw InputError(
      one_line(fmt::format("{}: larger than {} MB; expected a smaller file", file, kMaxBytes >> 20)));
}

}  // namespace

Node parse_text(const std::string& text, const std::string& file_name) {
  if (text.size() > kMaxBytes) fail_too_large(file_name);
  check_characters(text, file_name);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string body = text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  // yaml-cpp reads the version with the global locale, and refuses 1.2 where the decimal point is a comma.
  if (body.starts_with("%YAML 1.")) body[0] = '#';
  TreeBuilder builder(body, std::make_shared<const std::string>(file_name));
  try {
    std::istringstream stream(body);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    builder.fail_syntax(error);
  }
  std::optional<Node> root = builder.take_root();
  if (!root || root->kind() == Node::Kind::kNull) {
    throw InputError(one_line(file_name + ": empty, or nothing but comments; expected a YAML document"));
  }
  return std::move(*root);
}

Node parse_file(const std::string& path) {
  const auto fail = [&](const std::string& what) { throw InputError(one_line(path + ": " + what)); };
  std::error_code status_error;
  const std::filesystem::file_status status = std::filesystem::status(path, status_error);
  if (status.type() == std::filesystem::file_type::not_found) fail("no such file");
  if (status.type() == std::filesystem::file_type::directory) fail("is a directory; expected a YAML file");
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail("cannot be opened: " + std::generic_category().message(errno));
  // One byte more than allowed is enough to know, also for a pipe or a device that has no size.
  std::string text(kMaxBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) fail("cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return parse_text(text, path);
}

}  // namespace armtune::yaml
