// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/chained_registration.h"
#include "core/calibration/joint_registration.h"
#include "core/calibration/marker_detection.h"
#include "core/project/records.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/job.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace odo {

struct RegisterSettings
{
    std::string camera;
    std::string layout;
    std::filesystem::path pixelsFile; ///< label,u,v; or empty
    /// an image or video in which to detect the markers, or (with pixelsFile)
    std::filesystem::path imageFile;
    ///< that gives the image size of a camera without intrinsics; or empty
    std::vector<MarkerPixel> pixels; ///< picked in a window, in the camera's image; instead of pixelsFile
    StoredImage image = {};          ///< in which the pixels were picked, if the project has it already
    /// markers marked by hand, to find the others in the image (MarkerSearch)
    std::vector<MarkerPixel> hints = {};
    /// of the image that `pixels` belong to; 0: that at which the lens was calibrated
    int widthPx = 0, heightPx = 0;
};

/// Registers one camera to the floor by the markers of a layout and stores the registration as its newest
/// one, with the image in which the markers were seen. Where that image has another size than the lens was
/// calibrated at, the lens is fitted to it (fittedIntrinsics), stored as the camera's newest, and the verdict
/// says so. Without an image, it detects the markers in the camera's newest recording.
class RegisterJob : public Job
{
public:
    explicit RegisterJob(RegisterSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const RegisterSettings &settings() const { return m_settings; }
    const RegistrationRecord &record() const { return m_record; } ///< after run
    /// The record, with its lens stored first where that was fitted. For a commit, inside its transaction.
    Result<RegistrationRecord> withStoredIntrinsics(Project &project) const;

private:
    void takeSize(int widthPx, int heightPx);
    Result<void> findOtherCameras(Project &project, RecordId layout);
    Result<void> findInImages(const JobControl &control);
    Result<MarkerSearch> searchIn(const Frame &frame);
    void fitIntrinsics();
    Result<CameraModel> cameraModel() const;
    Result<void> keepImage();

    RegisterSettings m_settings;
    MarkerLayout m_layout;
    bool m_intrinsicsKnown = false;
    Intrinsics m_intrinsics; ///< stored ones or as fitted to the image, or only the image's size
    IntrinsicsRecord m_stored;
    Message m_fitting; ///< how m_intrinsics were fitted; empty: they are as stored
    RegistrationContext m_context;
    std::optional<Frame> m_seenIn; ///< the image that the markers were found in
    std::filesystem::path m_mediaFolder;
    std::unique_ptr<CalibrationMedia> m_media;
    RegistrationRecord m_record;
};

/// Words of the change that stores a camera's registration.
Message registerChange(const std::string &camera);

/// Registers a camera again from the pixels and the layout of its current registration, with the current
/// intrinsics: applies a newer calibration to the same markers, also for a camera that is long gone. NotFound
/// where it is not registered; InvalidInput where the registration was made with those intrinsics, or through
/// another camera. What the last check found stays. Quick.
Result<RegistrationRecord> registerWithCurrentIntrinsics(Project &project, const std::string &camera);

struct RegisterViaCameraSettings
{
    std::string camera;
    std::string reference; ///< a camera that is registered
    std::vector<SharedPoint> points;
    StoredImage image = {}; ///< of the camera, in which the points were picked, where the project has it
};

/// Registers a camera by points of the floor that a registered camera sees as well. Stores it as the camera's
/// newest registration, with the positions found as a layout of its own ("C through B", numbered where that
/// name is taken); the verdict names the registration it was made through. The camera needs intrinsics or a
/// recording, for its image size.
class RegisterViaCameraJob : public Job
{
public:
    explicit RegisterViaCameraJob(RegisterViaCameraSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const RegistrationRecord &record() const { return m_record; }   ///< after run; its layout after commit
    const std::string &layoutName() const { return m_layout.name; } ///< after commit

private:
    Result<void> findCamera(Project &project);

    RegisterViaCameraSettings m_settings;
    std::optional<FloorView> m_reference;
    RecordId m_referenceRegistration = 0;
    std::optional<CameraModel> m_camera;
    bool m_intrinsicsKnown = false;
    MarkerLayout m_layout;
    RegistrationRecord m_record;
};

/// Stores a camera's registration via another one as its newest, with its points as a layout of its own ("C
/// through B", numbered where that name is taken), whose name is filled in; the verdict names the reference's
/// registration. For a job's commit, inside its transaction.
Result<RegistrationRecord> storeViaCamera(Project &project, const std::string &camera,
                                          const std::string &reference, RecordId referenceRegistration,
                                          MarkerLayout &positions, RegistrationRecord record);

/// Whether a layout is one of those that registrations through this camera keep.
bool isLayoutOfReference(const std::string &layoutName, const std::string &reference);

struct RegisterJointSettings
{
    std::string layout;
    double tapeSigmaM = 0.002; ///< of the positions of the layout's markers
};

/// Registers all cameras of a layout jointly, from the pixels of their current registrations, and stores new
/// revisions of all of them in one transaction. The layout stays as it was measured; the verdicts name the
/// markers to remeasure. Errors as registerJointly.
class RegisterJointJob : public Job
{
public:
    explicit RegisterJointJob(RegisterJointSettings settings);
    Result<void> prepare(Project &project) override;
    Result<void> run(const JobControl &control) override;
    Result<void> commit(Project &project) override;

    const std::vector<std::string> &cameras() const { return m_names; } ///< after prepare
    /// The registrations in force, in the order of cameras(); after prepare and until commit.
    const std::vector<RegistrationRecord> &before() const { return m_records; }
    /// after run, in the order of cameras()
    const JointRegistration &joint() const { return m_joint; }

private:
    RegisterJointSettings m_settings;
    MarkerLayout m_layout;
    std::vector<std::string> m_names;
    std::vector<RegistrationRecord> m_records;
    std::vector<JointCamera> m_cameras;
    JointRegistration m_joint;
};

} // namespace odo
