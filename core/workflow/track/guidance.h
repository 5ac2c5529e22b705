// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/guidance_repository.h"
#include "core/tracking/searched_area.h"
#include "core/workflow/trial_sources.h"

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace odo {

class Project;

/// Guidance as a person gives it: by names and times.
struct GivenGuidance
{
    GuidanceItem::Kind kind = GuidanceItem::Kind::Ignore;
    /// its camera; of Hidden empty: all views
    std::string view;                      ///< its camera
    std::vector<Eigen::Vector2d> pointsPx; ///< luma pixels of upright frames
    std::string robot = {};                ///< of Point and Hidden; of Hidden empty: all robots
    double fromS = 0, toS = 0;             ///< of Point and Hidden: of the trial, both inside
    double sigmaPx = 0;                    ///< of a Point
};

/// What a person changes about the guidance of a trial.
struct GuidanceEdit
{
    bool clearsAll = false;        ///< first
    std::vector<RecordId> removed; ///< items
    std::vector<GivenGuidance> added;

    bool isEmpty() const { return !clearsAll && removed.empty() && added.empty(); }
};

/// The guidance of a trial with an edit of it, which is not stored yet.
struct EditedGuidance
{
    std::vector<GuidanceItem> all; ///< those that are added have no id yet
    std::vector<RecordId> removed;
    bool isByHandChanged = false; ///< points, or frames in which a robot is not visible
};

/// A point replaces that of the same robot, view and frame. Errors: NotFound for a view, robot or item that
/// the trial has not, InvalidInput for what is outside of the frame, and for times without a frame.
/// Project's thread.
Result<EditedGuidance> editedGuidance(Project &project, const TrialRecord &trial,
                                      const std::vector<RecordingRecord> &recordings,
                                      const GuidanceEdit &edit);

/// Stores what was edited. Project's thread.
Result<void> storeGuidance(Project &project, const EditedGuidance &edited);

/// Makes the edit of a trial one change, which can be undone. What was tracked before stays as it is: tracked
/// again, the trial is measured by it. Project's thread. Errors as those of editedGuidance.
Result<void> changeGuidance(Project &project, const std::string &trial, const GuidanceEdit &edit);

/// Whether a trial's stored observations were made by other areas than are stored now. Project's thread.
Result<bool> isGuidanceNew(Project &project, const TrialRecord &trial);

/// A series with the points that a person set and without what they say is not visible, as a series of its
/// own, which says so; nullopt: nothing is given of its robot and recording. Pure.
std::optional<ObservationSeries> correctedByHand(const ObservationSeries &tracked,
                                                 const std::vector<GuidanceItem> &items);

/// Overrides with one for each frame of the first view at which a point was set by hand: such a sample is
/// valid, unless it is overridden otherwise. Pure.
std::vector<ManualOverride> withPointsByHand(std::vector<ManualOverride> overrides,
                                             const std::vector<ViewTrack> &views);

/// Whether some are of single frames, which must then keep their numbers. Pure.
bool haveFrames(const std::vector<GuidanceItem> &items);

/// The marks of a recording. Pure.
std::vector<PointedOutRobot> marksOf(const std::vector<PointedOutRobot> &all, RecordId recording);

/// Where robots are searched in a recording. Pure.
SearchedArea searchedAreaOf(const std::vector<GuidanceItem> &items, RecordId recording);

} // namespace odo
