// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/camera_pair.h"
#include "core/calibration/related_registration.h"
#include "core/workflow/calibrate/calibrate_job.h"
#include "core/workflow/calibrate/paired_files.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct CalibratePairSettings
{
    std::array<std::string, 2> cameras;                      ///< A and B
    std::array<std::vector<std::filesystem::path>, 2> files; ///< of each
    BoardSpec board;
};

/// Finds one board in images that two cameras took at the same moments, and estimates where B is by A
/// (relateCameras), with the stored intrinsics of both. A camera without any is calibrated from these images,
/// as CalibrateJob does, and gets them stored.
///
/// Where one of them is registered to the floor (with a calibrated lens) and the other is not, the other is
/// registered via it and the relation, and the registration stored as RegisterViaCameraJob does. Where both
/// are, on the same axes, the relation is compared with them.
class CalibratePairJob : public Job
{
public:
    explicit CalibratePairJob(CalibratePairSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const CalibratePairSettings &settings() const { return m_settings; }
    const CameraPair &pair() const { return m_pair; }                           ///< after run
    const std::vector<std::string> &calibrated() const { return m_calibrated; } ///< cameras; after run

    /// A registration that follows from the pair.
    struct Joined
    {
        std::size_t side = 0; ///< of the camera that was registered; the other one is the reference
        std::string layout;   ///< after commit
        RegistrationRecord record;
    };
    const std::optional<Joined> &joined() const { return m_joined; } ///< after run
    /// Why none follows though one camera is registered; empty otherwise. A clause.
    const Message &whyNotJoined() const { return m_whyNotJoined; }
    /// How far B's registration is from A's and the relation, where both are registered.
    const std::optional<PoseDifference> &difference() const { return m_difference; }

private:
    /// One of the two cameras.
    struct Side
    {
        std::optional<Intrinsics> stored;
        int widthPx = 0, heightPx = 0;  ///< of its images
        std::vector<BoardImage> images; ///< kept where it has to be calibrated
        std::unique_ptr<CalibrationStorage> storage;
        RecordId intrinsics = 0;                        ///< those stored
        std::optional<RegistrationRecord> registration; ///< in force
        std::optional<PoseOnFloor> pose;                ///< by it, where its lens was calibrated
    };

    void searchPair(const FramePair &frames);
    std::optional<BoardView> findIn(const Frame &frame, const std::string &name, std::size_t side,
                                    Message &reason);
    Result<CameraModel> cameraOf(std::size_t side, const JobControl &control);
    Result<void> readRegistration(Project &project, RecordId camera, std::size_t side);
    void join(const std::array<CameraModel, 2> &cameras);
    Result<void> storeJoined(Project &project);

    CalibratePairSettings m_settings;
    std::vector<FilePair> m_files;
    std::filesystem::path m_mediaFolder;
    std::array<Side, 2> m_sides;
    std::vector<BoardPair> m_pairs; ///< with the board in both images
    std::array<std::vector<BoardView>, 2> m_views;
    std::vector<RejectedPair> m_rejected;
    CameraPair m_pair;
    std::vector<std::string> m_calibrated;
    bool m_haveCommonAxes = false;
    std::optional<Joined> m_joined;
    MarkerLayout m_joinedPositions;
    Message m_whyNotJoined;
    std::optional<PoseDifference> m_difference;
};

} // namespace odo
