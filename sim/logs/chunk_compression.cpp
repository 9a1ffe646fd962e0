#include "sim/logs/chunk_compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <new>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kFirstRoom = 4U << 20;  // bytes: a chunk of usual size is decompressed without moving
constexpr int kZstdLevel = 3;                 // the library's default

/// How far one call of a library came; failed: the bytes are not a frame.
struct FrameStep {
  std::size_t read = 0;
  std::size_t written = 0;
  bool at_end = false;  ///< of a frame
  bool failed = false;
};

FrameStep lz4_step(LZ4F_dctx* state, std::span<const std::byte> from, std::span<std::byte> to) {
  FrameStep step{from.size(), to.size()};
  const std::size_t hint = LZ4F_decompress(state, to.data(), &step.written, from.data(), &step.read, nullptr);
  step.failed = LZ4F_isError(hint) != 0;
  step.at_end = hint == 0;
  return step;
}

FrameStep zstd_step(ZSTD_DCtx* state, std::span<const std::byte> from, std::span<std::byte> to) {
  ZSTD_inBuffer in{from.data(), from.size(), 0};
  ZSTD_outBuffer out{to.data(), to.size(), 0};
  const std::size_t hint = ZSTD_decompressStream(state, &out, &in);
  return {in.pos, out.pos, hint == 0, ZSTD_isError(hint) != 0};
}

void check_compressed(bool failed, const char* why) {
  if (failed) throw FailedError(std::string("cannot compress a chunk: ") + why);
}

}  // namespace

struct ChunkDecoder::Frames {
  Frames() {
    if (LZ4F_isError(LZ4F_createDecompressionContext(&lz4, LZ4F_VERSION)) != 0) throw std::bad_alloc();
    zstd = ZSTD_createDCtx();
    if (zstd == nullptr) {
      LZ4F_freeDecompressionContext(lz4);
      throw std::bad_alloc();
    }
  }
  ~Frames() {
    LZ4F_freeDecompressionContext(lz4);
    ZSTD_freeDCtx(zstd);
  }
  Frames(const Frames&) = delete;
  Frames& operator=(const Frames&) = delete;

  LZ4F_dctx* lz4 = nullptr;
  ZSTD_DCtx* zstd = nullptr;
};

std::string_view chunk_compression_name(ChunkCompression compression) {
  if (compression == ChunkCompression::kLz4) return "lz4";
  return compression == ChunkCompression::kZstd ? "zstd" : "";
}

std::optional<ChunkCompression> chunk_compression_of(std::string_view name) {
  for (const auto known : {ChunkCompression::kNone, ChunkCompression::kLz4, ChunkCompression::kZstd})
    if (name == chunk_compression_name(known)) return known;
  return std::nullopt;
}

std::vector<std::byte> compressed_chunk(ChunkCompression compression, std::span<const std::byte> bytes) {
  std::vector<std::byte> frame;
  if (compression == ChunkCompression::kLz4) {
    LZ4F_preferences_t preferences = LZ4F_INIT_PREFERENCES;
    preferences.frameInfo.contentSize = bytes.size();
    frame.resize(LZ4F_compressFrameBound(bytes.size(), &preferences));
    const std::size_t size =
        LZ4F_compressFrame(frame.data(), frame.size(), bytes.data(), bytes.size(), &preferences);
    check_compressed(LZ4F_isError(size) != 0, LZ4F_getErrorName(size));
    frame.resize(size);
  } else if (compression == ChunkCompression::kZstd) {
    frame.resize(ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), kZstdLevel);
    check_compressed(ZSTD_isError(size) != 0, ZSTD_getErrorName(size));
    frame.resize(size);
  } else {
    frame.assign(bytes.begin(), bytes.end());
  }
  return frame;
}

ChunkDecoder::ChunkDecoder() : frames_(std::make_unique<Frames>()) {}
ChunkDecoder::~ChunkDecoder() = default;

void ChunkDecoder::begin(ChunkCompression compression, std::size_t size) {
  LZ4F_resetDecompressionContext(frames_->lz4);
  ZSTD_DCtx_reset(frames_->zstd, ZSTD_reset_session_only);
  compression_ = compression;
  size_ = size;
  filled_ = 0;
  between_frames_ = true;
  make_room(std::clamp<std::size_t>(size, 1, kFirstRoom));
}

void ChunkDecoder::make_room(std::size_t wanted) {
  if (content_.size() < wanted) content_.resize(wanted);
}

ChunkDecoder::Outcome ChunkDecoder::add(std::span<const std::byte> piece) {
  return compression_ == ChunkCompression::kNone ? add_plain(piece) : add_frame(piece);
}

ChunkDecoder::Outcome ChunkDecoder::add_plain(std::span<const std::byte> piece) {
  if (piece.size() > size_ - filled_) return Outcome::kTooLarge;
  if (content_.size() < filled_ + piece.size())
    make_room(std::min(size_, std::max(2 * content_.size(), filled_ + piece.size())));
  std::copy(piece.begin(), piece.end(), content_.begin() + static_cast<std::ptrdiff_t>(filled_));
  filled_ += piece.size();
  return Outcome::kGood;
}

ChunkDecoder::Outcome ChunkDecoder::add_frame(std::span<const std::byte> piece) {
  while (true) {
    const std::size_t room = std::min(content_.size(), size_) - filled_;
    const auto to = std::span(content_).subspan(filled_, room);
    const FrameStep step = compression_ == ChunkCompression::kLz4 ? lz4_step(frames_->lz4, piece, to)
                                                                  : zstd_step(frames_->zstd, piece, to);
    if (step.failed) return Outcome::kDamaged;
    between_frames_ = step.at_end;
    piece = piece.subspan(step.read);
    filled_ += step.written;
    // The libraries keep decompressed bytes back only where there was no more room for them.
    if (piece.empty() && (step.written < room || step.at_end)) return Outcome::kGood;
    if (step.read == 0 && step.written == 0 && room > 0) return Outcome::kDamaged;
    if (step.read == 0 && step.written == 0 && filled_ == size_)
      return piece.empty() ? Outcome::kGood : Outcome::kTooLarge;
    if (filled_ == content_.size() && filled_ < size_) make_room(std::min(size_, 2 * content_.size()));
  }
}

ChunkDecoder::Outcome ChunkDecoder::end() const {
  return filled_ == size_ && between_frames_ ? Outcome::kGood : Outcome::kTooSmall;
}

}  // namespace armtune::internal
