// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_access.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace objectness {
namespace fs = std::filesystem;
namespace {

Status bad(const std::string& message) { return Status::error(StatusCode::kBadInput, message); }

}  // namespace

Result<std::string> readFile(const std::string& path, std::uintmax_t max_bytes) {
  using Text = Result<std::string>;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return Text::error(bad("there is no such file"));
  if (!fs::is_regular_file(status)) return Text::error(bad("is not a file"));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return Text::error(bad("cannot be read: " + error.message()));
  if (size > max_bytes) {
    return Text::error(bad("is " + std::to_string(size) + " bytes long, more than the " + std::to_string(max_bytes) +
                           " that are read"));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) return Text::error(bad(std::string("cannot be read: ") + std::strerror(errno)));
  Text text;
  text.value.resize(size);
  file.read(text.value.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) != size) return Text::error(bad("cannot be read to its end"));
  return text;
}

Status writeFile(const std::string& path, const std::string& bytes) {
  const std::string unfinished = path + ".part";
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  if (file) file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file && std::rename(unfinished.c_str(), path.c_str()) == 0) return {};
  const std::string reason = std::strerror(errno);
  std::remove(unfinished.c_str());
  return bad("cannot write " + path + ": " + reason);
}

Status makeFolder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return {};
  return bad("cannot make the folder " + path + ": " + (error ? error.message() : "there is a file of that name"));
}

}  // namespace objectness
