#pragma once
// Names the place of an MCAP file where something is wrong.

#include <cstdint>
#include <string>

#include "armtune/error.hpp"
#include "sim/logs/mcap_format.hpp"

namespace armtune::internal {

/// The place of a record: its offset in the file, and for a record in a chunk also the one in the chunk's
/// content.
struct McapPlace {
  const std::string& file;
  McapRecord kind;
  std::uint64_t
      offset;  ///< bytes from the beginning of the file to the record, or to the chunk that holds it
  std::int64_t in_chunk =
      -1;  ///< bytes from the beginning of the chunk's content to the record; -1: not in a chunk
};

/// Returns the error for a damaged record. The sentence begins with the record: `fault.problem` is its
/// predicate, such as "is cut off". The key of the error's place is "byte N", with the offset in the file.
InputError mcap_error(const McapPlace& place, InputFault fault);

}  // namespace armtune::internal
