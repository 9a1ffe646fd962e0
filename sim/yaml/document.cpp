#include "sim/yaml/document.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <unordered_map>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/message_text.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal::yaml {
namespace {

constexpr std::string_view kCoreTags = "tag:yaml.org,2002:";

}  // namespace

/// Builds the tree of nodes from yaml-cpp's events, and throws at the first event that is not accepted.
/// Aliases are never expanded. A file with nested aliases or a huge list is therefore refused at little cost.
class TreeBuilder final : public YAML::EventHandler {
 public:
  /// text: the parsed text, to which yaml-cpp's marks refer; it must outlive the builder.
  /// scale: factor on the limits of the number of values and of the total length of the key paths.
  TreeBuilder(std::string_view text, std::shared_ptr<const std::string> file, std::size_t scale)
      : text_(text),
        file_(std::move(file)),
        max_items_(kMaxItems * scale),
        max_all_path_bytes_(kMaxAllPathBytes * scale) {}

  std::optional<Node> take_root() { return std::move(root_); }

  /// Throws InputError for a syntax error of yaml-cpp. The message is replaced or extended where it misleads.
  [[noreturn]] void fail_syntax(const YAML::Exception& error) const {
    const int line = std::max(error.mark.line, 0) + 1;
    if (error.msg.starts_with(YAML::ErrorMsg::UNKNOWN_ANCHOR)) refuse_alias(line);
    std::string what = "not valid YAML: " + error.msg;
    const bool unclosed =
        error.msg == YAML::ErrorMsg::END_OF_SEQ_FLOW || error.msg == YAML::ErrorMsg::END_OF_MAP_FLOW;
    if (unclosed && !open_.empty())
      what += fmt::format("; its bracket was opened on line {}", open_.back().node.line_);
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
  /// A list or map whose end was not reached yet.
  struct Open {
    Node node;
    std::optional<std::string> key;  ///< in a map: the key of the next value
    int key_line = 0;                ///< line of that key
    /// Line of every key so far. With a hash table the time for a large map does not grow quadratically.
    std::unordered_map<std::string, int> key_lines;
    bool is_key = false;  ///< true if this is itself the key of a map
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
    check_path(node);
    if (++item_count_ > max_items_) {
      fail_at(
          *file_, node.line_, {},
          fmt::format("the file has more than {} values, which is the most that armtune reads", max_items_),
          fmt::format("at most {} values", max_items_));
    }
    return node;
  }

  /// Throws InputError if the key paths are too long. Every value stores its path, so that one long key above
  /// a long list could otherwise fill the memory.
  void check_path(const Node& node) {
    if (node.key_path_.size() > kMaxPathBytes) {
      fail_at(*file_, node.line_, {},
              fmt::format("the keys down to this value are together longer than {} bytes; use shorter keys",
                          kMaxPathBytes),
              fmt::format("at most {} bytes", kMaxPathBytes));
    }
    path_bytes_ += node.key_path_.size();
    if (path_bytes_ > max_all_path_bytes_) {
      fail_at(*file_, node.line_, {},
              fmt::format("the keys down to all values are together longer than {} MB; use shorter keys",
                          max_all_path_bytes_ >> 20),
              fmt::format("at most {} MB", max_all_path_bytes_ >> 20));
    }
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
      fail_at(*file_, line_of(mark), {},
              fmt::format("nested more than {} levels deep; armtune's files need no more than 10", kMaxDepth),
              fmt::format("at most {} levels", kMaxDepth));
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
      open_.back().key.emplace();  // a placeholder; OnDocumentEnd() refuses the document
    } else {
      attach(std::move(node));
    }
  }

  void take_key(const YAML::Mark& mark, const std::string& key) {
    Open& map = open_.back();
    if (key.size() > kMaxKeyBytes) {
      throw error_at(*file_, line_of(mark), parent_path(),
                     {.problem = fmt::format("key {} has {} bytes", shown(key), key.size()),
                      .value = std::to_string(key.size()),
                      .limit = fmt::format("at most {}", kMaxKeyBytes)});
    }
    if (map.key_lines.size() == kMaxKeys) {
      fail_at(*file_, line_of(mark), parent_path(),
              fmt::format("more than {} keys in one map; expected fewer", kMaxKeys),
              fmt::format("at most {} keys", kMaxKeys));
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

  /// Throws InputError for a quote that is never closed. yaml-cpp accepts the end of the text in its place.
  /// The rest of the file would silently become part of the string, and its keys would get their defaults.
  void check_quotes(const YAML::Mark& mark) const {
    std::string_view rest = rest_at(mark);
    if (rest.starts_with('!')) {
      rest.remove_prefix(std::min(rest.find_first_of(" \t\r\n"), rest.size()));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    }
    if (closes_quote(rest)) return;
    fail_at(*file_, line_of(mark), next_path(),
            fmt::format("the quote {} opened here is never closed; close it", rest[0]));
  }

  /// Returns the line of an empty list element. yaml-cpp's mark is at the text that follows the element.
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
  /// Line and parent of the first key that is a list or a map. The key is refused only at the end of the
  /// document. Until then it could also be a bracket that is never closed, which has its own message.
  std::optional<std::pair<int, std::string>> container_key_;
  std::size_t max_items_;
  std::size_t max_all_path_bytes_;
  std::size_t item_count_ = 0;
  std::size_t path_bytes_ = 0;
  int documents_ = 0;
};

Node parse_text(const std::string& text, const std::string& file_name, std::size_t max_bytes) {
  if (text.size() > max_bytes) refuse_large(file_name, max_bytes);
  check_characters(text, file_name);
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  std::string body = text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  // yaml-cpp reads the version in the global locale. It refuses 1.2 if the decimal point is a comma there.
  if (body.starts_with("%YAML 1.")) body[0] = '#';
  const std::size_t scale = std::max<std::size_t>(1, max_bytes / kMaxBytes);
  TreeBuilder builder(body, std::make_shared<const std::string>(file_name), scale);
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
    throw InputError(InputPlace{file_name},
                     InputFault{.problem = "empty, or nothing but comments", .limit = "a YAML document"});
  }
  return std::move(*root);
}

Node parse_file(const std::string& path) {
  return parse_text(read_input_file(path, kMaxBytes, "a YAML file"), path);
}

Node parse_file(const std::string& path, std::size_t max_bytes) {
  return parse_text(read_file(path, max_bytes, "a YAML file"), path, max_bytes);
}

}  // namespace armtune::internal::yaml
