// SPDX-License-Identifier: BSD-3-Clause
#include "objectness_segmentation/io/pcd_file.hpp"

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "io/pcd_header.hpp"
#include "io/quiet_pcl.hpp"

namespace objectness {
namespace {

const pcl::PCLPointField* findField(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  for (const auto& field : cloud.fields) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

template <class T>
T valueAt(const pcl::PCLPointCloud2& cloud, std::size_t point, std::size_t offset) {
  T value;
  std::memcpy(&value, cloud.data.data() + point * cloud.point_step + offset, sizeof value);
  return value;
}

float coordinate(const pcl::PCLPointCloud2& cloud, std::size_t point, const pcl::PCLPointField& field) {
  return field.datatype == pcl::PCLPointField::FLOAT64 ? static_cast<float>(valueAt<double>(cloud, point, field.offset))
                                                       : valueAt<float>(cloud, point, field.offset);
}

Result<RawCloud> toRawCloud(const pcl::PCLPointCloud2& cloud) {
  const pcl::PCLPointField* axes[3] = {findField(cloud, "x"), findField(cloud, "y"), findField(cloud, "z")};
  for (const pcl::PCLPointField* axis : axes) {
    if (axis && (axis->datatype == pcl::PCLPointField::FLOAT32 || axis->datatype == pcl::PCLPointField::FLOAT64))
      continue;
    return Result<RawCloud>::error(StatusCode::kBadInput, "has no floating-point fields x, y and z");
  }
  const pcl::PCLPointField* color = findField(cloud, "rgb") ? findField(cloud, "rgb") : findField(cloud, "rgba");
  if (color && color->offset + 4 > cloud.point_step) color = nullptr;  // no packed colour
  Result<RawCloud> raw;
  raw.value.width = static_cast<int>(cloud.width);
  raw.value.height = static_cast<int>(cloud.height);
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (cloud.data.size() < count * cloud.point_step) return Result<RawCloud>::error(StatusCode::kBadInput, "is cut off");
  raw.value.points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    raw.value.points.emplace_back(coordinate(cloud, i, *axes[0]), coordinate(cloud, i, *axes[1]),
                                  coordinate(cloud, i, *axes[2]));
    // PCL packs a colour into four bytes: blue, green, red, alpha.
    if (color) {
      const auto bgra = valueAt<std::array<unsigned char, 4>>(cloud, i, color->offset);
      raw.value.colors.emplace_back(bgra[0], bgra[1], bgra[2]);
    }
  }
  return raw;
}

/// The VIEWPOINT of a file; none when it says nothing, as most do, or is no pose.
std::optional<Eigen::Isometry3d> viewpointOf(const Eigen::Vector4f& origin, const Eigen::Quaternionf& orientation) {
  constexpr double kMaxNormError = 0.01;
  const Eigen::Quaterniond rotation = orientation.cast<double>();
  const Eigen::Vector3d position = origin.head<3>().cast<double>();
  if (!position.allFinite() || !(std::abs(rotation.norm() - 1) <= kMaxNormError)) return {};
  const Eigen::Isometry3d pose = Eigen::Translation3d(position) * rotation.normalized();
  if (pose.isApprox(Eigen::Isometry3d::Identity(), 1e-6)) return {};
  return pose;
}

}  // namespace

Result<RawCloud> loadPcd(const std::string& path) {
  const Result<PcdLayout> header = checkPcdHeader(path);
  if (!header.ok()) return Result<RawCloud>::error(header.status);
  const QuietPcl quiet;  // the caller gets a Status instead
  try {
    pcl::PCLPointCloud2 cloud;
    Eigen::Vector4f origin;
    Eigen::Quaternionf orientation;
    int version = 0;
    int kind = 0;
    unsigned data_offset = 0;
    pcl::PCDReader reader;
    // What was checked has to be what PCL goes by: where it ends a header too early it reads through null pointers.
    const bool agrees = reader.readHeader(path, cloud, origin, orientation, version, kind, data_offset) >= 0 &&
                        data_offset == header.value.data_offset;
    if (!agrees) {
      return Result<RawCloud>::error(StatusCode::kBadInput,
                                     "is damaged: PCL reads its header otherwise, as when there is a line of blanks");
    }
    const bool read = reader.read(path, cloud, origin, orientation, version) >= 0;
    if (read && cloud.width == header.value.width && cloud.height == header.value.height) {
      Result<RawCloud> raw = toRawCloud(cloud);
      raw.value.T_cloud_sensor = viewpointOf(origin, orientation);
      return raw;
    }
  } catch (const std::exception&) {
    // The reason is in PCL's terms, of no help to a user.
  }
  return Result<RawCloud>::error(StatusCode::kBadInput, "is a damaged PCD file: its data do not fit its header");
}

}  // namespace objectness
