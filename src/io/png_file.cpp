// SPDX-License-Identifier: BSD-3-Clause
#include "io/png_file.hpp"

#include <boost/crc.hpp>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "io/file_access.hpp"
#include "scene/image_limits.hpp"

namespace objectness {
namespace {

constexpr std::uintmax_t kMaxPngBytes = 1u << 30;
// Deflate packs at most 1032 bytes into one: a header that claims more pixels than that lies.
constexpr std::uint64_t kMaxDeflateRatio = 1032;
constexpr std::size_t kSignatureBytes = 8, kChunkFrameBytes = 12;

struct PngHeader {
  std::uint32_t width = 0, height = 0;
  int bits = 0, color_type = 0;
  std::uint64_t packed_bytes = 0;  ///< of all pixel data

  int channels() const { return color_type == 2 ? 3 : color_type == 4 ? 2 : color_type == 6 ? 4 : 1; }
  std::uint64_t bytes() const { return std::uint64_t{width} * height * channels() * bits / 8; }
  std::string text() const {
    return std::to_string(bits) + "-bit with " + std::to_string(channels()) +
           (channels() == 1 ? " channel" : " channels");
  }
};

std::uint32_t bigEndian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

Result<PngHeader> bad(const std::string& message) { return Result<PngHeader>::error(StatusCode::kBadInput, message); }

/// The format of a picture that is often called .png by mistake, "" when it is none of these.
std::string otherFormat(const std::string& bytes) {
  const std::pair<std::string, const char*> signatures[] = {{std::string("II*\0", 4), "TIFF"},
                                                            {std::string("MM\0*", 4), "TIFF"},
                                                            {"\xff\xd8\xff", "JPEG"},
                                                            {"\x76\x2f\x31\x01", "OpenEXR"},
                                                            {"P5", "PGM"},
                                                            {"Pf", "PFM"},
                                                            {"\x93NUMPY", "NumPy"}};
  for (const auto& [signature, format] : signatures) {
    if (bytes.compare(0, signature.size(), signature) == 0) return format;
  }
  return "";
}

/// Walks over the chunks of the file.
Result<PngHeader> checkPng(const std::string& bytes) {
  if (bytes.empty()) return bad("is empty");
  if (bytes.compare(0, kSignatureBytes, "\x89PNG\r\n\x1a\n") != 0) {
    const std::string other = otherFormat(bytes);
    return bad(other.empty() ? "is not a PNG image" : "is a " + other + " image, must be PNG: convert it");
  }
  Result<PngHeader> header;
  for (std::size_t at = kSignatureBytes; at + kChunkFrameBytes <= bytes.size();) {
    const std::size_t length = bigEndian(bytes, at);
    if (length > bytes.size() - at - kChunkFrameBytes) break;
    const std::string type = bytes.substr(at + 4, 4);
    boost::crc_32_type checksum;
    checksum.process_bytes(bytes.data() + at + 4, length + 4);
    if (checksum.checksum() != bigEndian(bytes, at + 8 + length))
      return bad("is damaged (wrong checksum): make or copy it again");
    if (type == "IHDR" && length == 13) {
      header.value.width = bigEndian(bytes, at + 8);
      header.value.height = bigEndian(bytes, at + 12);
      header.value.bits = bytes[at + 16];
      header.value.color_type = bytes[at + 17];
    } else if (type == "IDAT") {
      header.value.packed_bytes += length;
    } else if (type == "IEND") {
      return header;
    }
    at += kChunkFrameBytes + length;
  }
  return bad("is cut off after " + std::to_string(bytes.size()) + " bytes: make or copy it again");
}

}  // namespace

Result<cv::Mat> readPng(const std::string& path, PngKind kind) {
  using Image = Result<cv::Mat>;
  const Result<std::string> file = readFile(path, kMaxPngBytes);
  if (!file.ok()) return Image::error(file.status);
  const Result<PngHeader> checked = checkPng(file.value);
  if (!checked.ok()) return Image::error(checked.status);
  const PngHeader& header = checked.value;
  if (header.width < 1 || header.height < 1 || header.width > kMaxSidePx || header.height > kMaxSidePx ||
      header.width * header.height > kMaxPixels ||
      header.bytes() > header.packed_bytes * kMaxDeflateRatio + kMaxDeflateRatio) {
    return Image::error(StatusCode::kBadInput, "claims to be " + std::to_string(header.width) + " x " +
                                                   std::to_string(header.height) + " pixels, which it cannot hold");
  }
  if (kind != PngKind::kColor && (header.bits != 16 || header.channels() != 1)) {
    const char* meaning =
        kind == PngKind::kDepth ? "depth in millimetres (or --depth-scale), 0 where there is none" : "a label a pixel";
    return Image::error(StatusCode::kBadInput, "is " + header.text() + ", must be 16-bit with 1 channel: " + meaning);
  }
  try {
    cv::Mat image =
        cv::imdecode(cv::Mat(1, static_cast<int>(file.value.size()), CV_8UC1, const_cast<char*>(file.value.data())),
                     kind == PngKind::kColor ? cv::IMREAD_COLOR : cv::IMREAD_UNCHANGED);
    if (!image.empty()) return {{}, image};
  } catch (const cv::Exception&) {
    // The reason is in OpenCV's terms, of no help to a user.
  }
  return Image::error(StatusCode::kBadInput, "cannot be decoded: it is damaged");
}

Status writePng(const std::string& path, const cv::Mat& image) {
  std::vector<uchar> bytes;
  try {
    if (!cv::imencode(".png", image, bytes)) return Status::error(StatusCode::kInternalError, "cannot encode " + path);
  } catch (const cv::Exception& e) {
    return Status::error(StatusCode::kInternalError, "cannot encode " + path + ": " + e.what());
  }
  return writeFile(path, std::string(bytes.begin(), bytes.end()));
}

}  // namespace objectness
