#include "core/robot/xml_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/input_place.hpp"
#include "core/robot/xacro.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMaxBytes = 32u << 20;
constexpr int kMaxDepth = 1'000;
constexpr int kMaxLinks = 10'000;
constexpr int kMaxElements = 200'000;
constexpr int kMaxAttributes = 100;  // per tag: tinyxml searches all of them for every new one
/// Elements that a link or joint may have only once: urdfdom reads the first and ignores others silently.
constexpr std::array<std::string_view, 9> kOnce = {
    "inertial", "origin", "parent", "child", "axis", "limit", "mimic", "dynamics", "safety_controller"};
constexpr std::string_view kSpace = " \t\r\n";
constexpr auto kEnd = std::string_view::npos;

/// Returns the value of a tag's attribute, or nullopt if the tag has no attribute of this name.
std::optional<std::string_view> attribute_of(std::string_view body, std::string_view name) {
  for (std::size_t at = body.find(name); at != kEnd; at = body.find(name, at + 1)) {
    const std::size_t equals = body.find_first_not_of(kSpace, at + name.size());
    if (at == 0 || kSpace.find(body[at - 1]) == kEnd || equals == kEnd || body[equals] != '=') continue;
    const std::size_t quote = body.find_first_not_of(kSpace, equals + 1);
    if (quote == kEnd || (body[quote] != '"' && body[quote] != '\'')) continue;
    return body.substr(quote + 1, body.find(body[quote], quote + 1) - quote - 1);
  }
  return std::nullopt;
}

/// Returns the name of the URDF that the expansion of a xacro file could have, in the current folder:
/// `arm.urdf` for `arm.urdf.xacro` and `arm.xacro`, `arm_expanded.urdf` for `arm.urdf`.
std::string expanded_name(const std::string& path) {
  const std::filesystem::path name = std::filesystem::path(path).filename();
  const bool is_xacro = name.extension() == ".xacro";
  const std::filesystem::path rest = is_xacro ? name.stem() : name;
  const std::string stem = (rest.extension() == ".urdf" ? rest.stem() : rest).string();
  return stem + (is_xacro ? ".urdf" : "_expanded.urdf");
}

/// Returns the path as an argument of a command that a user can copy into a shell.
std::string argument(const std::string& path) {
  return path.find(' ') == kEnd ? path : "'" + path + "'";
}

/// True if the program xacro has to expand the file, by its name or by what is in it.
bool is_xacro(const std::string& path, std::string_view text) {
  if (path.ends_with(".xacro")) return true;
  constexpr std::array<std::string_view, 5> kMarks = {"<xacro:", "\"${", "'${", "\"$(", "'$("};
  return std::any_of(kMarks.begin(), kMarks.end(),
                     [text](std::string_view mark) { return text.find(mark) != kEnd; });
}

/// Checks all tags in one pass, without recursion. It reads tags as tinyxml does: quoted text inside tags is
/// skipped, and comments and CDATA end at their first end mark. A `<` inside a tag is refused, so that both
/// parsers agree on where an element starts.
class Scanner {
 public:
  Scanner(const std::string& path, std::string_view text) : path_(path), text_(text) {}

  void run() {
    for (std::size_t at = text_.find('<'); at != kEnd; at = text_.find('<', at)) {
      if (text_.substr(at).starts_with("<!--")) {
        at = end_of(at, 4, "-->");
      } else if (text_.substr(at).starts_with("<![CDATA[")) {
        at = end_of(at, 9, "]]>");
      } else {
        at = tag(at);
      }
    }
  }

  /// Returns the text with the missing limits inserted.
  std::string completed() const {
    std::string whole;
    std::size_t from = 0;
    for (const auto& [at, words] : put_in_) {
      whole += text_.substr(from, at - from);
      whole += words;
      from = at;
    }
    return whole.append(text_.substr(from));
  }

 private:
  /// key: the element, such as `joint/axis`.
  InputError error_at(std::size_t at, std::string_view key, const std::string& problem) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return {at_line(path_, line, std::string(key)), problem};
  }

  template <typename... Args>
  [[noreturn]] void refuse(std::size_t at, fmt::format_string<Args...> text, Args&&... args) const {
    throw error_at(at, {}, fmt::format(text, std::forward<Args>(args)...));
  }

  [[noreturn]] void refuse_xacro(std::size_t at, std::string_view found) const {
    const std::string command = fmt::format("xacro {} > {}", argument(path_), argument(expanded_name(path_)));
    const std::string problem = fmt::format(
        "'{}': this is xacro, not URDF; expand it first: {} (ROS 2: ros2 run xacro {}), or let armtune run "
        "xacro with the option --xacro",
        found, command, command);
    throw error_at(at, {}, problem).with_value(std::string(found), "URDF without xacro");
  }

  std::size_t end_of(std::size_t at, std::size_t opening, std::string_view mark) const {
    const std::size_t end = text_.find(mark, at + opening);
    if (end == kEnd) refuse(at, "'{}' has no closing '{}'; add it", text_.substr(at, opening), mark);
    return end + mark.size();
  }

  /// Reads the tag that opens at `at`. Returns the position after its `>`.
  std::size_t tag(std::size_t at) {
    std::size_t end = at + 1;
    int attributes = 0;
    for (; end < text_.size() && text_[end] != '>'; ++end) {
      if (text_[end] == '<') break;
      if (text_[end] == '"' || text_[end] == '\'') end = attribute(at, end);
      if (text_[end] == '%') refuse_format(end);
      if (text_[end] == '=' && ++attributes > kMaxAttributes)
        throw error_at(at, {},
                       fmt::format("a tag has more than {} attributes; a URDF needs no more than 10; remove "
                                   "those that it does not need",
                                   kMaxAttributes))
            .with_value({}, fmt::format("at most {} attributes", kMaxAttributes));
    }
    if (end >= text_.size() || text_[end] == '<') refuse(at, "a tag is not closed by '>'; close it");
    const std::string_view body = text_.substr(at + 1, end - at - 1);
    if (body.starts_with('/')) {
      if (depth_ == 2 && needs_limit_) put_in_.emplace_back(at, "<limit velocity='0' effort='0'/>");
      if (depth_ == 2) needs_limit_ = false;
      depth_ = std::max(0, depth_ - 1);
    } else if (!body.starts_with('!') && !body.starts_with('?')) {
      element(at, body);
    }
    return end + 1;
  }

  void element(std::size_t at, std::string_view body) {
    const std::string_view name = body.substr(0, body.find_first_of(" \t\r\n/"));
    if (name.starts_with("xacro:")) refuse_xacro(at, fmt::format("<{}>", name));
    if (elements_ == 0) refuse_other_format(at, name);
    if (++elements_ > kMaxElements) refuse_number(at, kMaxElements, "elements");
    if (name == "link" && ++links_ > kMaxLinks) refuse_number(at, kMaxLinks, "links");
    refuse_second(at, name);
    complete_limit(at, name, body);
    if (!body.ends_with('/') && ++depth_ > kMaxDepth)
      throw error_at(
          at, name,
          fmt::format("elements are nested deeper than {}; a URDF needs no more than 10", kMaxDepth))
          .with_value({}, fmt::format("at most {} levels", kMaxDepth));
  }

  [[noreturn]] void refuse_number(std::size_t at, int most, const char* what) const {
    throw error_at(
        at, {},
        fmt::format("the file has more than {} {}; armtune needs a serial arm, which has far fewer", most,
                    what))
        .with_value({}, fmt::format("at most {} {}", most, what));
  }

  /// Refuses SDF and MJCF files, which the name of their first element reveals.
  void refuse_other_format(std::size_t at, std::string_view name) const {
    if (name == "sdf") {
      throw error_at(at, name,
                     "this is an SDF file, but armtune reads URDF; convert it, for example with sdf2urdf of "
                     "sdformat_tools or of pysdf")
          .with_value(std::string(name), "URDF");
    }
    if (name == "mujoco" || name == "mujocoinclude") {
      throw error_at(
          at, name,
          "this is an MJCF file of MuJoCo, but armtune reads URDF; use the vendor's URDF, or convert the "
          "file, for example with the Python package mjcf-urdf-simple-converter")
          .with_value(std::string(name), "URDF");
    }
  }

  /// Refuses a second element of kOnce in one link or joint. Links and joints are at depth 1, and elements
  /// inside them are at depth 2.
  void refuse_second(std::size_t at, std::string_view name) {
    if (depth_ == 1) {
      owner_ = name;
      seen_.clear();
    }
    if (depth_ != 2 || (owner_ != "link" && owner_ != "joint")) return;
    if (std::find(kOnce.begin(), kOnce.end(), name) == kOnce.end()) return;
    if (std::find(seen_.begin(), seen_.end(), name) != seen_.end())
      throw error_at(at, fmt::format("{}/{}", owner_, name),
                     fmt::format("a second <{}> in one <{}>; remove one of the two", name, owner_))
          .with_value({}, fmt::format("one <{}>", name));
    seen_.push_back(name);
  }

  /// Notes where to insert a velocity or effort limit of 0, because it is missing. armtune treats 0 as
  /// missing, while urdfdom would refuse the whole file.
  void complete_limit(std::size_t at, std::string_view name, std::string_view body) {
    if (depth_ == 1) {
      const auto type = attribute_of(body, "type");
      needs_limit_ = name == "joint" && !body.ends_with('/') && (type == "revolute" || type == "prismatic");
    }
    if (depth_ != 2 || owner_ != "joint" || name != "limit") return;
    needs_limit_ = false;
    for (const char* limit : {"velocity", "effort"}) {
      if (!attribute_of(body, limit))
        put_in_.emplace_back(at + 1 + name.size(), fmt::format(" {}='0'", limit));
    }
  }

  /// Checks the attribute value that opens at `quote` in the tag at `at`. Returns the end quote's position.
  std::size_t attribute(std::size_t at, std::size_t quote) const {
    const std::size_t end = text_.find(text_[quote], quote + 1);
    if (end == kEnd) refuse(quote, "an attribute has no closing quote; add it");
    const std::string_view value = text_.substr(quote + 1, end - quote - 1);
    if (value.find('<') != kEnd)
      refuse(quote, "'<' inside an attribute; add the closing quote if it is missing, or write &lt;");
    if (value.find("${") != kEnd || value.find("$(") != kEnd) refuse_xacro(quote, value);

    std::string_view before = text_.substr(at, quote - at);
    before = before.substr(0, before.find_last_not_of(" \t\r\n=") + 1);
    const bool is_filename =
        before.ends_with("filename") && before.size() > 8 && kSpace.find(before[before.size() - 9]) != kEnd;
    if (!is_filename && (value.find('%') != kEnd || value.find("&#") != kEnd)) refuse_format(quote);
    return end;
  }

  [[noreturn]] void refuse_format(std::size_t at) const {
    // urdfdom 3.0 passes a number that it cannot read to printf as the format: mass="%s%n" crashes it.
    refuse(at, "'%' or a character reference '&#..;' in a tag; only the attribute 'filename' may hold one");
  }

  const std::string& path_;
  std::string_view text_;
  int depth_ = 0;
  int elements_ = 0;
  int links_ = 0;
  bool needs_limit_ = false;                                 ///< true if the open joint has no limit so far
  std::vector<std::pair<std::size_t, std::string>> put_in_;  ///< positions, and the text to insert there
  std::string_view owner_;                                   ///< the last element at depth 1
  std::vector<std::string_view> seen_;                       ///< elements of kOnce found in owner_
};

}  // namespace

std::string read_guarded_urdf(const std::string& path) {
  std::string text = read_input_file(path, kMaxBytes, "a URDF file");
  std::string shown = path;
  if (is_xacro(path, text)) {
    if (auto expanded = expanded_xacro(path, kMaxBytes)) {
      text = std::move(*expanded);
      shown += " (expanded)";  // lines in messages are those of the expanded text
    }
  }
  if (text.empty()) throw InputError(InputPlace{path}, "is empty");
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.find('\0') != std::string::npos)
    throw InputError(InputPlace{path}, "is UTF-16 or binary; save it as UTF-8");
  Scanner scanner(shown, text);
  scanner.run();
  return scanner.completed();
}

}  // namespace armtune::internal
