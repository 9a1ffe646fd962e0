#include "sim/logs/message_labels.hpp"

#include <algorithm>

#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kLongestLabel = 256;

}  // namespace

void MessageLabels::read(CdrReader& reader, std::size_t count, std::size_t string_bound) {
  bool is_whole = count_ == 0 && count > 0 && count <= most_;
  const bool is_first = order_.empty();
  if (is_whole) {
    is_changed_ = is_changed_ || count != order_.size();
    order_.resize(count, 0);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view name = reader.string(string_bound);
    is_whole = is_whole && name.size() <= kLongestLabel && reader.fault() == CdrFault::kNone;
    if (is_whole) set(i, name);
  }
  if (!is_whole) return;
  count_ = count;
  if (!is_changed_) return;
  is_changed_ = false;
  changes_ += is_first ? 0 : 1;
  is_in_order_ = true;
  is_met_.assign(raw_.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    is_in_order_ = is_in_order_ && order_[i] == i;
    are_distinct_ = are_distinct_ && is_met_[order_[i]] == 0;
    is_met_[order_[i]] = 1;
  }
  // Elements of one name cannot be told apart: then they keep their places.
  is_in_order_ = is_in_order_ || !are_distinct_;
}

void MessageLabels::set(std::size_t i, std::string_view name) {
  if (order_[i] < raw_.size() && raw_[order_[i]] == name) return;
  is_changed_ = true;
  order_[i] = static_cast<std::uint32_t>(index_of(name));
}

std::size_t MessageLabels::index_of(std::string_view name) {
  const auto known = std::find(raw_.begin(), raw_.end(), name);
  if (known != raw_.end()) return static_cast<std::size_t>(known - raw_.begin());
  if (raw_.size() >= most_) {
    are_distinct_ = false;
    return 0;
  }
  raw_.emplace_back(name);
  names_.push_back(one_line(name));
  return raw_.size() - 1;
}

}  // namespace armtune::internal
