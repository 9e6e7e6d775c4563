// SPDX-License-Identifier: BSD-3-Clause
#include "io/pcd_header.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <vector>

namespace objectness {
namespace {

constexpr std::uint64_t kMaxPoints = 64u << 20;
constexpr std::uint64_t kMaxPointBytes = 4096;
constexpr int kMaxHeaderLines = 100;
constexpr std::size_t kMaxLineBytes = 65536;
// LZF packs at most 264 bytes into three.
constexpr std::uint64_t kMaxLzfRatio = 264 / 3;

const char* const kKeys[] = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                             "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
constexpr int kLongestKey = 9;

struct PcdHeader {
  std::map<std::string, std::vector<std::string>> entries;  ///< "WIDTH" -> {"640"}
  std::uint64_t data_offset = 0;

  std::uint64_t number(const std::string& key) const {
    const auto found = entries.find(key);
    if (found == entries.end() || found->second.empty()) return 0;
    // A sign or a fraction fails the comparison with the text.
    const std::uint64_t value = std::strtoull(found->second[0].c_str(), nullptr, 10);
    return std::to_string(value) == found->second[0] ? value : 0;
  }
  /// Element i of a per-field entry, 1 (as PCL) when the entry is missing.
  std::uint64_t perField(const std::string& key, std::size_t i) const {
    const auto found = entries.find(key);
    if (found == entries.end()) return 1;
    return i < found->second.size() ? std::strtoull(found->second[i].c_str(), nullptr, 10) : 0;
  }
};

Status bad(const std::string& message) { return Status::error(StatusCode::kBadInput, message); }

bool isText(unsigned char c) { return std::isprint(c) || c == '\t' || c == '\r'; }

/// PCL reads past the end of entries that are fewer than the fields.
bool perFieldEntriesFit(const PcdHeader& header) {
  const std::size_t fields = header.entries.at("FIELDS").size();
  for (const char* key : {"SIZE", "TYPE", "COUNT"}) {
    const auto found = header.entries.find(key);
    if (found != header.entries.end() && found->second.size() != fields) return false;
  }
  const auto& types = header.entries.at("TYPE");
  return std::all_of(types.begin(), types.end(),
                     [](const std::string& type) { return type == "F" || type == "I" || type == "U"; });
}

/// PCL reads on as if in the header after DATA, over empty lines and comments, as long as a line begins with a key: the
/// fields would not be those that were checked.
bool goesOnAfterData(std::ifstream& file) {
  for (std::string word; file >> std::setw(kLongestKey) >> word;) {
    if (word[0] == '#') {
      file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
      continue;
    }
    const auto begins = [&](const char* key) { return word.rfind(key, 0) == 0; };
    return begins("COLUMNS") || std::any_of(std::begin(kKeys), std::end(kKeys), begins);
  }
  return false;
}

Result<PcdHeader> readHeader(std::ifstream& file) {
  Result<PcdHeader> header;
  std::string line;
  for (int i = 0; i < kMaxHeaderLines; ++i) {
    line.clear();
    for (char c; line.size() < kMaxLineBytes && file.get(c) && c != '\n';) line += c;
    if (!file || line.size() == kMaxLineBytes) break;
    std::istringstream words(line);
    std::string key, word;
    words >> key;
    if (key.empty() || key[0] == '#') continue;
    if (!header.value.entries.empty() && !std::all_of(line.begin(), line.end(), isText)) {
      return Result<PcdHeader>::error(bad("is damaged: its header is no text"));
    }
    if (key == "COLUMNS") key = "FIELDS";
    // PCL looks only at how a line begins, and at the last one of a kind.
    if (std::find(std::begin(kKeys), std::end(kKeys), key) == std::end(kKeys)) {
      if (header.value.entries.empty()) break;
      return Result<PcdHeader>::error(bad("is damaged: its header has a line '" + key.substr(0, 20) + "'"));
    }
    if (header.value.entries.count(key)) {
      return Result<PcdHeader>::error(bad("is damaged: its header has two lines " + key));
    }
    std::vector<std::string>& values = header.value.entries[key];
    while (words >> word) values.push_back(word);
    if (key == "DATA") {
      const std::ifstream::pos_type data = file.tellg();
      header.value.data_offset = static_cast<std::uint64_t>(data);
      if (goesOnAfterData(file)) return Result<PcdHeader>::error(bad("is damaged: its header goes on after its DATA"));
      file.clear();
      file.seekg(data);
      return header;
    }
  }
  const bool begins_as_pcd = header.value.entries.count("FIELDS") || header.value.entries.count("VERSION");
  return Result<PcdHeader>::error(
      bad(begins_as_pcd ? "is cut off within its header: make or copy it again" : "is not a PCD file"));
}

Status checkDataSize(const PcdHeader& header, std::uint64_t points, std::uint64_t point_bytes, std::uint64_t data_bytes,
                     std::ifstream& file) {
  const std::uint64_t needed = points * point_bytes;
  const std::string cut_off = "is cut off: its header announces " + std::to_string(points) + " points, its " +
                              std::to_string(data_bytes) + " bytes of data hold fewer; make or copy it again";
  const auto format = header.entries.at("DATA");
  const std::string name = format.empty() ? "" : format[0];
  if (name == "ascii") {
    // A digit and a blank a number.
    return data_bytes + 1 < 2 * points * header.entries.at("FIELDS").size() ? bad(cut_off) : Status();
  }
  if (name == "binary") return data_bytes < needed ? bad(cut_off) : Status();
  if (name != "binary_compressed") return bad("has data of the unknown kind '" + name + "'");
  char sizes[8] = {};
  if (!file.read(sizes, sizeof sizes)) return bad(cut_off);
  std::uint32_t packed = 0, unpacked = 0;
  std::memcpy(&packed, sizes, 4);
  std::memcpy(&unpacked, sizes + 4, 4);
  if (packed > data_bytes - sizeof sizes) return bad(cut_off);
  if (unpacked != needed || unpacked > packed * kMaxLzfRatio) {
    return bad("contradicts itself: its header announces " + std::to_string(needed) + " bytes, its compressed data " +
               std::to_string(unpacked));
  }
  return {};
}

}  // namespace

Result<PcdLayout> checkPcdHeader(const std::string& path) {
  const auto unusable = [](const std::string& message) { return Result<PcdLayout>::error(bad(message)); };
  std::error_code error;
  const auto type = std::filesystem::status(path, error);
  if (!std::filesystem::exists(type)) return unusable("there is no such file");
  if (!std::filesystem::is_regular_file(type)) return unusable("is not a file");
  const std::uint64_t size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) return unusable("cannot be read: check its permissions");
  if (size == 0) return unusable("is empty");

  const Result<PcdHeader> read = readHeader(file);
  if (!read.ok()) return Result<PcdLayout>::error(read.status);
  const PcdHeader& header = read.value;
  for (const char* key : {"FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT"}) {
    if (!header.entries.count(key)) return unusable(std::string("has no ") + key + " line in its header");
  }
  const std::uint64_t width = header.number("WIDTH"), height = header.number("HEIGHT");
  const std::uint64_t points = header.entries.count("POINTS") ? header.number("POINTS") : width * height;
  const std::string size_text = header.entries.at("WIDTH").empty() || header.entries.at("HEIGHT").empty()
                                    ? "no size"
                                    : header.entries.at("WIDTH")[0] + " x " + header.entries.at("HEIGHT")[0];
  if (width == 0 || height == 0) return unusable("has no points: its header says " + size_text);
  if (width > kMaxPoints || height > kMaxPoints || width * height > kMaxPoints) {
    return unusable("claims " + size_text + " points, more than the " + std::to_string(kMaxPoints) + " that are read");
  }
  if (points != width * height) {
    return unusable("contradicts itself: WIDTH x HEIGHT is " + size_text + ", POINTS is " + std::to_string(points));
  }
  if (!perFieldEntriesFit(header)) return unusable("has a SIZE, TYPE or COUNT that is wrong or missing in its header");
  std::uint64_t point_bytes = 0;
  for (std::size_t i = 0; i < header.entries.at("FIELDS").size(); ++i) {
    const std::uint64_t size_i = header.perField("SIZE", i), count = header.perField("COUNT", i);
    const bool known = size_i == 1 || size_i == 2 || size_i == 4 || size_i == 8;
    if (!known || count < 1 || count > kMaxPointBytes)
      return unusable("has a SIZE, TYPE or COUNT that is wrong or missing in its header");
    point_bytes += size_i * count;
  }
  if (point_bytes == 0 || point_bytes > kMaxPointBytes)
    return unusable("has fields of " + std::to_string(point_bytes) + " bytes a point");
  const Status data = checkDataSize(header, points, point_bytes, size - header.data_offset, file);
  if (!data.ok()) return Result<PcdLayout>::error(data);
  return {Status{}, {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), header.data_offset}};
}

}  // namespace objectness
