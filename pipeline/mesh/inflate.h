// Smoothing without shrinking: what flat triangles cut off a round surface is given back.
#pragma once

#include <functional>

#include "pipeline/package/patient_package.h"

namespace vallecula::pipeline {

/// Area-weighted unit normals of the points.
std::vector<Point> point_normals(const Surface& surface);

/// How much of the inflation a place takes, 0 .. 1; empty: all of it everywhere.
using InflationShare = std::function<double(const Point&)>;

/// Every point moved outwards along its normal, mm.
Surface inflated(const Surface& surface, double by_mm, const InflationShare& share = {});

/// How far a closed surface must be inflated to hold `volume_mm3`, mm; meant for what its triangles lost, which is a
/// small part of their size.
double inflation_to(const Surface& surface, double volume_mm3, const InflationShare& share = {});

}  // namespace vallecula::pipeline
