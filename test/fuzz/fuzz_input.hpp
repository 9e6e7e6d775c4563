// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

/// What libFuzzer calls with each input; every target defines it, and replay.cpp calls it as well.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace objectness_fuzz {

/// Ends the process as a crash does: what a target promises does not hold.
inline void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", promise);
  std::abort();
}

/// Values from the front of an input; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  template <class T>
  T take() {
    T value{};
    const std::size_t count = size_ < sizeof(T) ? size_ : sizeof(T);
    std::memcpy(&value, data_, count);
    advance(count);
    return value;
  }
  /// The next bytes: a part that the input gives a length of its own, or all that is left.
  std::string part() {
    const std::size_t wanted = take<std::uint16_t>();
    return text(wanted < size_ ? wanted : size_);
  }
  std::string rest() { return text(size_); }

 private:
  std::string text(std::size_t count) {
    std::string bytes(reinterpret_cast<const char*>(data_), count);
    advance(count);
    return bytes;
  }
  void advance(std::size_t count) {
    data_ += count;
    size_ -= count;
  }

  const std::uint8_t* data_;
  std::size_t size_;
};

/// A folder for the files of this process, in memory where there is such a place; removed at its end.
class Folder {
 public:
  Folder() {
    const std::filesystem::path memory = "/dev/shm", elsewhere = std::filesystem::temp_directory_path();
    std::string name = ((access(memory.c_str(), W_OK) == 0 ? memory : elsewhere) / "objectness_fuzz_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path() const { return path_.string(); }
  /// An empty text removes the file.
  std::string write(const char* name, const std::string& bytes) const {
    const std::string path = (path_ / name).string();
    if (bytes.empty()) {
      std::remove(path.c_str());
    } else {
      std::ofstream(path, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<long>(bytes.size()));
    }
    return path;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace objectness_fuzz
