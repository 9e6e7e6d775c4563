// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sim/shapes.hpp"

namespace objectness::sim {

// Solids of revolution that stand on z = 0; metres.

Revolution cylinder(double radius, double height);

/// A frustum; with top_radius 0 a whole cone.
Revolution cone(double bottom_radius, double top_radius, double height);

Revolution sphere(double radius);

/// Open at the top: what lies between two spheres about a centre at height centre_z, cut off at the rim and flat at the
/// foot. `radius` is the outer sphere's and more than centre_z; `height` is the rim's.
Revolution bowl(double radius, double height, double thickness, double centre_z);

/// Open at the top, walls upright.
Revolution cup(double radius, double height, double thickness);

/// A plate or pan, open at the top: a flat floor up to floor_radius, and from there a straight wall that leans outwards
/// up to `radius`. The wall is `thickness` wide at the rim.
Revolution dish(double radius, double height, double thickness, double floor_radius);

/// A lid with a knob: an upright rim, from there a part of a sphere up to the knob, which starts at height `height`.
Revolution lid(double radius, double rim_height, double height, double knob_radius, double knob_height);

/// A closed bottle: body, shoulder and neck.
Revolution bottle(double radius, double height, double neck_radius, double shoulder_z, double neck_z);

/// The handle of a cup of that outer radius, on its +x side: half a ring of a rod. Its ends are sunk into the wall by
/// less than `thickness`. `span` is the height between them, `centre_z` the height of their middle.
Tube handle(double cup_radius, double thickness, double centre_z, double span, double rod_radius);

}  // namespace objectness::sim
