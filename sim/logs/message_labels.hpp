#pragma once
// The names that messages give their elements, such as the joints of a JointState.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/cdr_reader.hpp"

namespace armtune::internal {

/// Keeps the names of all messages of a topic in the order in which they appeared, and says which of them an
/// element of the current message has. Messages of one topic can have different names, for example if arm and
/// gripper both publish on /joint_states.
class MessageLabels {
 public:
  explicit MessageLabels(std::size_t most) : most_(most) {}

  /// Begins a message, which has no names yet.
  void begin() { count_ = 0; }
  /// Reads a sequence of `count` strings as the names of this message. They are passed over if the message
  /// has names already, if there are more than `most`, or if a name is longer than 256 bytes.
  void read(CdrReader& reader, std::size_t count, std::size_t string_bound);

  /// Returns the place of element i of a sequence with `count` elements: the index of its name, if the
  /// sequence has as many elements as this message has names, otherwise i.
  std::size_t place(std::size_t i, std::size_t count) const {
    return is_in_order_ || count != count_ ? i : order_[i];
  }

  /// Returns all names as printable text.
  const std::vector<std::string>& names() const { return names_; }
  /// Returns how many messages had other names, or another order of them, than the message before.
  std::size_t changes() const { return changes_; }

 private:
  void set(std::size_t i, std::string_view name);
  std::size_t index_of(std::string_view name);

  std::size_t most_;
  std::vector<std::string> raw_;      // as in the messages
  std::vector<std::string> names_;    // the same, printable
  std::vector<std::uint32_t> order_;  // index in raw_ of the names of the latest message that had names
  std::size_t count_ = 0;             // names of the current message
  bool is_in_order_ = true;           // order_ is 0, 1, 2, ...
  bool are_distinct_ = true;          // no message had a name twice
  bool is_changed_ = false;           // order_ changed since is_in_order_ was computed
  std::vector<std::uint8_t> is_met_;  // workspace of read()
  std::size_t changes_ = 0;
};

}  // namespace armtune::internal
