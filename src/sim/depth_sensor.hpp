// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "objectness_segmentation/io/scene_folder.hpp"
#include "sim/surface_view.hpp"

namespace objectness::sim {

enum class SensorKind {
  kStructuredLight,  ///< like the first Kinect
  kStereo,           ///< active stereo, like a RealSense D400
  kTimeOfFlight      ///< modulated light, like an Azure Kinect
};

/// A depth camera, its colour image registered to the depth. Unless said otherwise, of structured light.
///
/// [N] C. V. Nguyen, S. Izadi, D. Lovell: Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking.
///     3DIMPVT 2012.
/// [K] K. Khoshelham, S. O. Elberink: Accuracy and Resolution of Kinect Depth Data for Indoor Mapping Applications.
///     Sensors 12(2), 2012.
/// [T] K. Konolige, P. Mihelich: Technical description of Kinect calibration. ROS wiki, kinect_calibration/technical.
/// [G] A. Grunnet-Jepsen, J. N. Sweetser, J. Woodfill: Best-Known-Methods for Tuning Intel RealSense D400 Depth Cameras
///     for Best Performance. Intel white paper, 2018.
/// [L] R. Lange, P. Seitz: Solid-State Time-of-Flight Range Camera. IEEE Journal of Quantum Electronics 37(3), 2001.
/// [K10] A. Kolb, E. Barth, R. Koch, R. Larsen: Time-of-Flight Cameras in Computer Graphics. Computer Graphics Forum
///     29(1), 2010: flying pixels, wiggling.
/// [J] D. Jimenez, D. Pizarro, M. Mazo, S. Palazuelos: Modeling and correction of multipath interference in time of
///     flight cameras. Image and Vision Computing 32(1), 2014.
/// [A] Azure Kinect DK hardware specifications. Microsoft: the range of its narrow field of view.
struct DepthSensor {
  SensorKind kind = SensorKind::kStructuredLight;
  PinholeCamera camera{525, 525, 319.5, 239.5, 640, 480};
  bool ideal = false;  ///< every surface point gives its depth, rounded to a millimetre: nothing of what follows

  double baseline_m = 0.075;         ///< projector to the right of the camera [T]: what it does not light has no depth
  double disparity_step_px = 0.125;  ///< disparity is measured in steps of this [K, T]
  double min_depth_m = 0.4, max_depth_m = 4.0;
  /// A pixel is lost with a probability that grows linearly with the angle of incidence, from 0 to 1 between these.
  /// We know of no published law for it: the ramp is our own.
  double grazing_start_deg = 70, grazing_end_deg = 84;

  double subpixel_px = 0.1;  ///< stereo: RMS error of the disparity; 0.05 to 0.2 [G]

  double tof_sigma_m = 0.001;    ///< time of flight: RMS error of a white surface a metre away, seen from straight on
  double modulation_hz = 100e6;  ///< of the light
  double wiggle_m = 0.001;       ///< amplitude of the systematic error, four waves in the range of a phase [K10]

  /// A time-of-flight camera of that lens: no projector beside it, 0.5 to 3.86 m [A].
  static DepthSensor timeOfFlight(const PinholeCamera& camera);

  /// An active stereo camera of that lens: a baseline of 5 cm, finer steps, from 0.2 m on.
  static DepthSensor stereo(const PinholeCamera& camera);

  /// Standard deviation of the measured depth at incidence theta (radians from the surface's normal), metres: sigma_z
  /// of [N], steps included. Stereo: z^2 / (f b) * subpixel_px [G], at any incidence. Time of flight:
  /// tof_sigma_m * z / sqrt(cos(theta)): the error of a phase falls with the root of the light, which comes back with
  /// cos(theta) / z^2 [L].
  double axialSigma(double z, double theta = 0) const;

  /// Standard deviation of an edge's place in the image, pixels: sigma_L of [N].
  static double lateralSigma(double theta);

  /// From one depth to the next that can be measured, metres: z^2 / (f b) * disparity_step_px [K].
  double depthStep(double z) const { return z * z * disparity_step_px / (camera.fx * baseline_m); }
};

/// What the sensor measures of a view. Labels are those of the surfaces that gave the depths, 0 where there is none.
///
/// The noise depends on the seed alone. It is smooth, because neighbouring pixels are matched by windows that overlap:
/// over 3 pixels along the ray; over 9 pixels (the matching window, 9 x 9 or 9 x 7 by [T]) across it, so that edges are
/// wavy rather than frayed; lost pixels come in patches. The deviation of each single pixel is the published one. The
/// noise of stereo is half of waves, 25 pixels wide, and its depths are blended over the matching window. Time of
/// flight has timeOfFlightDepths() in the place of displaced edges and of steps. threads: 0 one per processor; the
/// result does not depend on it.
SceneImages takePicture(const SurfaceView& view, const DepthSensor& sensor, std::uint32_t seed, int threads = 0);

/// Sees and measures.
SceneImages takePicture(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                        const DepthSensor& sensor, std::uint32_t seed);

/// viewSurfaces() with the sensor's projector.
SurfaceView viewSurfaces(const std::vector<Body>& bodies, const Eigen::Isometry3d& T_world_camera,
                         const DepthSensor& sensor);

}  // namespace objectness::sim
