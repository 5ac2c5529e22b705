// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/internal/silhouette_finder.h"

#include <cstddef>
#include <vector>

namespace odo {

/// Takes the convex hull of points of a silhouette's edge, and what is measured of it.
void measureHull(SeenSilhouette &silhouette, std::vector<Eigen::Vector2d> edgePoints);

/// Joins to each silhouette the small ones that are near it, or that its shadow connects with it: a wheel
/// behind a side that looks like the floor. seen: the largest first, and so are they left.
void joinFragments(std::vector<SeenSilhouette> &seen);

/// Joins those that one shadow connects: sides of a robot may look like floor in shadow.
void joinByShadow(std::vector<SeenSilhouette> &seen);
/// Notes of each what share it would gain by that (ShadowAmbiguity::apart).
void noteApart(std::vector<SeenSilhouette> &seen);

/// Silhouettes that may be parts of one body, of which what lies between looks like the floor: those that are
/// so near one another for their size, in groups of two or more, as indices. Pure.
std::vector<std::vector<std::size_t>> groupsOfParts(const std::vector<SeenSilhouette> &seen);

/// Notes of each silhouette that has a small one near it that something was left out: what joins the two may
/// be too thin to be seen, or look like the floor (a camera on a mast). seen: the largest first.
void noteBeside(std::vector<SeenSilhouette> &seen);

/// The silhouette whose hull is that of some parts together.
SeenSilhouette joined(const std::vector<SeenSilhouette> &seen, const std::vector<std::size_t> &parts);

} // namespace odo
