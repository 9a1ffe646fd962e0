#include "tuner/report/record_entries.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::report {
namespace {

using Entries = std::vector<std::pair<std::string, std::string>>;

template <typename T>
void add_entries(Entries& entries, const std::string& path, const T& value);

/// A visitor that adds an entry for every member that `declare` visits. Empty members are left out.
class EntryList {
 public:
  EntryList(Entries& entries, std::string path) : entries_(entries), path_(std::move(path)) {}

  EntryList& type(const char*, const char* = "") { return *this; }

  template <typename T>
  EntryList& operator()(const char* key, const T& value, const char* = "",
                        record::Presence = record::Presence::kAlways) {
    add_entries(entries_, path_.empty() ? key : path_ + "/" + key, value);
    return *this;
  }
  template <typename T>
  EntryList& operator()(const char* key, const T& value, record::Words words, const char* = "",
                        record::Presence presence = record::Presence::kAlways) {
    if constexpr (std::is_same_v<T, bool>) return (*this)(key, words.begin()[value ? 1 : 0]);
    return (*this)(key, value, "", presence);
  }

 private:
  Entries& entries_;
  std::string path_;
};

/// Adds the members of an item of a list. The first one, if it is a text, becomes part of the path instead.
template <typename T>
void add_item(Entries& entries, const std::string& list, std::size_t number, const T& item) {
  if constexpr (record::Text<T> || std::is_arithmetic_v<T>) {
    add_entries(entries, fmt::format("{}/{}", list, number), item);
  } else {
    Entries members;
    EntryList fields(members, {});
    record::declare(fields, item);
    std::string path = fmt::format("{}/{}", list, number);
    if (members.size() > 1) {
      path = list + "/" + members.front().second;
      members.erase(members.begin());
    }
    for (auto& [key, value] : members) entries.emplace_back(path + "/" + key, std::move(value));
  }
}

template <typename T>
void add_entries(Entries& entries, const std::string& path, const T& value) {
  if (record::is_empty(value)) return;
  if constexpr (std::is_enum_v<T>) {
    entries.emplace_back(path, name(value));
  } else if constexpr (record::Text<T> || std::is_arithmetic_v<T>) {
    entries.emplace_back(path, fmt::format("{}", value));
  } else if constexpr (record::Optional<T>) {
    add_entries(entries, path, *value);
  } else if constexpr (record::List<T>) {
    std::size_t number = 0;
    for (const auto& item : value) add_item(entries, path, ++number, item);
  } else {
    EntryList fields(entries, path);
    record::declare(fields, value);
  }
}

}  // namespace

Provenance provenance_of(const RunRecord& record) {
  Provenance provenance{record.command, {}};
  add_entries(provenance.entries, "", record);
  return provenance;
}

void refuse_old_record(const std::string& folder) {
  if (find_run_file(folder, kRunRecord)) return;
  if (const auto old = find_run_file(folder, kOldRunRecord)) {
    throw InputError(
        InputPlace{*old},
        "an older version of armtune made this run; use `armtune report` of that version to show this file");
  }
}

}  // namespace armtune::internal::report
