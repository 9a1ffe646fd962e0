#include "sim/yaml/placed_value.hpp"

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
#include "sim/yaml/document.hpp"
#include "sim/yaml/source_text.hpp"

namespace armtune::internal::yaml {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class PlacedBuilder final : public YAML::EventHandler {
 public:
  /// text: the file without its byte order mark. before: size of that mark [byte]. text and file must outlive
  /// the builder.
  PlacedBuilder(std::string_view text, std::size_t before, const std::string& file)
      : text_(text), before_(before), file_(file) {}

  Placed take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, "a second document starts here; expected one document in a file");
  }
  void OnDocumentEnd() override {}

  void OnAnchor(const YAML::Mark&, const std::string&) override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) fail(mark, "an alias refers to a value that contains it; remove the alias");
    if (takes_key(mark, found->second->text)) return;
    attach(found->second, true);
  }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (takes_key(mark, {})) return;
    finish(start(mark, PlacedValue::Kind::kNull), anchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                const std::string& value) override {
    if (takes_key(mark, value)) return;
    auto scalar = start(mark, PlacedValue::Kind::kScalar);
    scalar->text = value;
    // A scalar gets no position if its text in the file differs from its value (quoted, tagged, folded).
    const std::size_t at =
        behind_anchor(std::min(text_.size(), static_cast<std::size_t>(std::max(mark.pos, 0))));
    if (!closes_quote(text_.substr(at))) fail(mark, "the quote opened here is never closed; close it");
    if (!value.empty() && text_.substr(at).starts_with(value)) {
      scalar->begin = before_ + at;
      scalar->end = scalar->begin + value.size();
    }
    finish(scalar, anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, PlacedValue::Kind::kSequence, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, PlacedValue::Kind::kMap, anchor);
  }
  void OnMapEnd() override {
    merge(*open_.back().value);
    close();
  }

 private:
  struct Open {
    std::shared_ptr<PlacedValue> value;
    YAML::anchor_t anchor = 0;
    std::optional<std::string> key;  ///< in a map: the key of the next value
    std::unordered_map<std::string, int> key_lines;
  };

  [[noreturn]] void fail(const YAML::Mark& mark, std::string what) const {
    fail_at(file_, mark.line + 1, {}, std::move(what));
  }

  /// Returns the position of the value that follows an anchor at `at`; `at` itself if there is no anchor.
  std::size_t behind_anchor(std::size_t at) const {
    if (at >= text_.size() || text_[at] != '&') return at;
    const std::size_t blank = std::min(text_.find_first_of(" \t\r\n", at), text_.size());
    return std::min(text_.find_first_not_of(" \t\r\n", blank), text_.size());
  }

  std::shared_ptr<PlacedValue> start(const YAML::Mark& mark, PlacedValue::Kind kind) {
    count(mark.line + 1, 1);
    auto value = std::make_shared<PlacedValue>();
    value->kind = kind;
    value->line = mark.line + 1;
    return value;
  }

  void count(int line, std::size_t more) {
    values_ += more;
    if (values_ > kMaxItems)
      fail_at(
          file_, line, {},
          fmt::format("the file has more than {} values, which is the most that armtune reads", kMaxItems),
          fmt::format("at most {} values", kMaxItems));
  }

  bool takes_key(const YAML::Mark& mark, const std::string& key) {
    if (open_.empty() || open_.back().value->kind != PlacedValue::Kind::kMap || open_.back().key)
      return false;
    Open& map = open_.back();
    const auto [first, is_new] = map.key_lines.emplace(key, mark.line + 1);
    // ROS 2 reads the parameters of a node, such as '/**', from several places of a file.
    const bool is_node = open_.size() == 1 && key.starts_with('/');
    if (!is_new && key != "<<" && !is_node) {
      fail(mark, fmt::format("duplicate key {}, already on line {}; remove one of the two", shown(key),
                             first->second));
    }
    map.key = key;
    return true;
  }

  void open(const YAML::Mark& mark, PlacedValue::Kind kind, YAML::anchor_t anchor) {
    if (!open_.empty() && open_.back().value->kind == PlacedValue::Kind::kMap && !open_.back().key)
      fail(mark, "a key is a list or a map; write a text before the ':'");
    if (open_.size() == kMaxDepth) fail(mark, fmt::format("nested more than {} levels deep", kMaxDepth));
    open_.push_back({start(mark, kind), anchor, {}, {}});
  }
  void close() {
    const Open closed = std::move(open_.back());
    open_.pop_back();
    finish(closed.value, closed.anchor);
  }
  void finish(const std::shared_ptr<PlacedValue>& value, YAML::anchor_t anchor) {
    value->anchored = anchor != 0;
    if (value->anchored) anchors_[anchor] = value;
    attach(value);
  }
  void attach(const Placed& value, bool alias = false) {
    if (open_.empty()) {
      root_ = value;
      return;
    }
    Open& parent = open_.back();
    if (parent.value->kind == PlacedValue::Kind::kMap) {
      parent.value->entries.push_back({std::move(*parent.key), value, alias});
      parent.key.reset();
    } else {
      parent.value->items.push_back({{}, value, alias});
    }
  }

  /// Adds the entries of the maps to which "<<" refers, except those whose keys the map has itself.
  void merge(PlacedValue& map) {
    std::vector<Placed> merged;
    for (const PlacedEntry& entry : map.entries) {
      if (entry.key != "<<") continue;
      if (entry.value->kind == PlacedValue::Kind::kSequence) {
        for (const PlacedEntry& item : entry.value->items) merged.push_back(item.value);
      } else {
        merged.push_back(entry.value);
      }
    }
    if (merged.empty()) return;
    std::erase_if(map.entries, [](const PlacedEntry& entry) { return entry.key == "<<"; });
    for (const Placed& other : merged) {
      for (const PlacedEntry& entry : other->entries) {
        if (map.find(entry.key) != nullptr) continue;
        count(map.line, 1);
        map.entries.push_back({entry.key, entry.value, true});
      }
    }
  }

  std::string_view text_;
  std::size_t before_;
  const std::string& file_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, Placed> anchors_;
  Placed root_;
  std::size_t values_ = 0;
  int documents_ = 0;
};

}  // namespace

const PlacedValue* PlacedValue::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [key](const PlacedEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : found->value.get();
}

Placed read_placed(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes) refuse_large(file, kMaxBytes);
  check_characters(text, file);
  const std::size_t before = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  std::string body = text.substr(before);
  if (body.starts_with("%YAML 1.")) body[0] = '#';
  PlacedBuilder builder(body, before, file);
  try {
    std::istringstream stream(body);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    fail_at(file, std::max(error.mark.line, 0) + 1, {}, "not valid YAML: " + error.msg);
  }
  Placed root = builder.take_root();
  if (!root || root->kind == PlacedValue::Kind::kNull)
    throw InputError(InputPlace{file},
                     InputFault{.problem = "empty, or nothing but comments", .limit = "a YAML document"});
  return root;
}

}  // namespace armtune::internal::yaml
