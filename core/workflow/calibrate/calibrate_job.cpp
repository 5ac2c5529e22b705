// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workflow/calibrate/calibrate_job.h"

#include "core/base/error.h"
#include "core/calibration/board_placement.h"
#include "core/calibration/board_vote.h"
#include "core/calibration/intrinsic_calibration.h"
#include "core/calibration/repeated_views.h"
#include "core/files/protected_files.h"
#include "core/project/project.h"
#include "core/project/records.h"
#include "core/project/repositories.h"
#include "core/video/frame_turn.h"
#include "core/video/image.h"
#include "core/video/image_reader.h"
#include "core/workflow/calibrate/calibration_images.h"
#include "core/workflow/calibrate/cameras.h"
#include "core/workflow/calibrate/internal/clip_frames.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace odo {

Message calibrationOf(const std::string &camera)
{
    return ODO_TEXT("workflow.calibration_of_camera", "calibration of camera '%1'")(Named::camera(camera));
}

CalibrationStorage::CalibrationStorage(const std::filesystem::path &mediaFolder, std::string camera,
                                       IntrinsicCalibration calibration, const BoardSpec &board)
    : m_media(mediaFolder), m_camera(std::move(camera))
{
    m_record.origin =
        ODO_TEXT("workflow.calibrated_from_pictures", "calibrated from %1 images")(calibration.imagesUsed());
    m_record.calibration = std::move(calibration);
    m_record.board = board;
    m_record.softwareVersion = ODOGRAPH_VERSION;
}

Result<void> CalibrationStorage::writeImages(const std::vector<BoardImage> &images, const JobControl &control)
{
    const auto &used = m_record.calibration.images;
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (control.isCancelled())
            return cancelled(calibrationOf(m_camera));
        control.report(double(i) / double(used.size()),
                       ODO_TEXT("workflow.keeping_pictures", "saving the images"));
        const auto image = std::ranges::find(images, used[i].view.source, &BoardImage::source);
        m_record.files.emplace_back(); // those without an image have none
        if (image == images.end())
            continue;
        const std::string name = m_camera + "_" + std::filesystem::path(used[i].view.source).stem().string();
        m_record.files.back() = ODO_TRY(m_media.write(name, image->png));
    }
    return {};
}

Result<IntrinsicsRecord> CalibrationStorage::commit(Project &project)
{
    const auto stored =
        project.change(ODO_TEXT("workflow.calibrate_camera", "calibrate camera %1")(Named::camera(m_camera)),
                       [&]() -> Result<void> {
                           const auto camera = ODO_TRY(findOrAddCamera(project, m_camera));
                           m_record.camera = camera.id;
                           m_record.made = instantNow();
                           m_record = ODO_TRY(project.cameras().addIntrinsics(m_record));
                           return {};
                       });
    if (!stored)
        return tl::unexpected(stored.error());
    m_media.keep();
    return m_record;
}

namespace {

constexpr std::size_t mostFramesOfClip = 60;
constexpr double blurredBy = 1.5; // times the edges of the sharper frames of a clip

/// The value that most have; among equals the first.
template <class Value>
Value mostFrequent(const std::vector<Value> &values)
{
    return *std::ranges::max_element(values, {},
                                     [&](const Value &value) { return std::ranges::count(values, value); });
}

/// Those of a clip's views that are sharp, and of these at most so many that differ most from one another.
std::vector<std::size_t> spreadViews(const std::vector<const BoardView *> &views, int widthPx, int heightPx)
{
    std::vector<double> widths;
    for (const BoardView *view : views)
        widths.push_back(view->edgeWidthPx);
    std::ranges::sort(widths);
    const double sharp = widths.empty() ? 0 : widths[widths.size() / 4];
    std::vector<std::size_t> left, chosen;
    std::vector<std::optional<BoardPlacement>> placements;
    for (std::size_t i = 0; i < views.size(); ++i) {
        placements.push_back(placementOf(*views[i], widthPx, heightPx));
        if (views[i]->edgeWidthPx <= blurredBy * sharp && placements[i])
            left.push_back(i);
    }
    while (!left.empty() && chosen.size() < mostFramesOfClip) {
        const auto news = [&](std::size_t i) {
            double least = HUGE_VAL;
            for (const std::size_t before : chosen)
                least = std::min(least, distanceOf(*placements[i], *placements[before]));
            return least;
        };
        const auto next = std::ranges::max_element(left, {}, news);
        chosen.push_back(*next);
        left.erase(next);
    }
    return chosen;
}

} // namespace

CalibrateJob::CalibrateJob(CalibrateSettings settings) : m_settings(std::move(settings)) {}

Result<void> CalibrateJob::prepare(Project &project)
{
    m_mediaFolder = project.mediaFolder();
    for (const auto &file : m_settings.files)
        ODO_TRY(checkMayBeRead(file, quotedName(Named::file(file))));
    return {};
}

Result<void> CalibrateJob::run(const JobControl &control)
{
    for (std::size_t i = 0; i < m_settings.files.size(); ++i) {
        control.report(0.8 * double(i) / double(m_settings.files.size()),
                       ODO_TEXT("workflow.looking_for_board_in",
                                "detecting the board in %1")(Named::file(m_settings.files[i].filename())));
        ODO_TRY(searchFile(m_settings.files[i], control));
    }
    settle(control);
    if (control.isCancelled())
        return cancelled(calibrationOf(m_settings.camera));
    collect();
    if (m_views.empty())
        return tl::unexpected(noBoard());
    control.report(0.85, ODO_TEXT("workflow.computing_intrinsics", "computing the intrinsics"));
    auto calibration = calibrateIntrinsics(m_views, m_widthPx, m_heightPx, m_settings.model, control);
    if (!calibration) {
        Error error = calibration.error();
        error.what = calibrationOf(m_settings.camera);
        return tl::unexpected(error);
    }
    m_calibration = std::move(*calibration);
    m_calibration.rejected.insert(m_calibration.rejected.begin(), m_rejected.begin(), m_rejected.end());
    m_storage = std::make_unique<CalibrationStorage>(m_mediaFolder, m_settings.camera, m_calibration,
                                                     m_settings.board);
    auto written = m_storage->writeImages(m_images, control);
    if (!written)
        m_storage.reset();
    return written;
}

Error CalibrateJob::noBoard() const
{
    const Message why = m_rejected.empty()
                            ? Message(ODO_TEXT("workflow.no_picture_read", "no image could be read"))
                            : m_rejected.front().reason;
    return {ErrorCode::Undetermined, calibrationOf(m_settings.camera),
            ODO_TEXT("workflow.board_in_no_picture",
                     "the board was found in none of %1 images (%2)")(m_rejected.size(), why),
            ODO_TEXT("workflow.show_whole_board",
                     "show the whole board, flat, sharp and evenly lit, and check --pattern and --board")};
}

Result<void> CalibrateJob::searchFile(const std::filesystem::path &file, const JobControl &control)
{
    const bool isStill = isStillImage(file);
    const std::size_t first = m_searched.size();
    const auto visit = [&](const Frame &frame, const std::string &name) {
        searchImage(frame, name, isStill ? file : std::filesystem::path());
        return !control.isCancelled();
    };
    const auto visitStill = [&](const Frame &image) { visit(image, file.filename().string()); };
    const auto visited =
        isStill ? readImage(file).map(visitStill) : visitSharpestFrames(file, visit, control.cancel);
    if (control.isCancelled())
        return cancelled(calibrationOf(m_settings.camera));
    // One unreadable image among many is refused like one without a board; it must not cost the others.
    if (!visited)
        m_rejected.push_back({file.filename().string(), visited.error().why});
    if (!isStill)
        searchClip(file, first);
    return {};
}

/// Leaves of a clip's frames those that a calibration needs, and counts the others.
void CalibrateJob::searchClip(const std::filesystem::path &file, std::size_t first)
{
    std::vector<const BoardView *> views;
    std::vector<std::size_t> indices;
    std::vector<std::pair<Message, int>> reasons;
    for (std::size_t i = first; i < m_searched.size(); ++i) {
        const Searched &image = m_searched[i];
        if (image.view) {
            views.push_back(&*image.view);
            indices.push_back(i);
            continue;
        }
        const auto known = std::ranges::find_if(
            reasons, [&](const auto &one) { return one.first.code() == image.reason.code(); });
        if (known == reasons.end())
            reasons.emplace_back(image.reason, 1);
        else
            ++known->second;
    }
    for (const auto &[reason, count] : reasons)
        m_rejected.push_back({file.filename().string(),
                              ODO_TEXT("workflow.frames_without_board", "%1 frames: %2")(count, reason)});
    if (first == m_searched.size())
        return;
    std::vector<std::size_t> chosen =
        spreadViews(views, m_searched[first].widthPx, m_searched[first].heightPx);
    std::ranges::sort(chosen);
    std::vector<Searched> kept;
    for (const std::size_t i : chosen)
        kept.push_back(std::move(m_searched[indices[i]]));
    m_searched.resize(first);
    std::ranges::move(kept, std::back_inserter(m_searched));
}

void CalibrateJob::searchImage(const Frame &frame, const std::string &name,
                               const std::filesystem::path &still)
{
    Searched image{name, still, 0, 0, 1, std::nullopt, {}};
    std::vector<BoardView> before;
    for (const Searched &other : m_searched) {
        if (other.view && m_settings.board.columns == 0)
            before.push_back(*other.view);
    }
    const auto likely = likelyBoard(before, frame.format.width, frame.format.height);
    take(image, frame, findBoardForVote(frame, m_settings.board, likely, name));
    m_searched.push_back(std::move(image));
}

void CalibrateJob::take(Searched &image, const Frame &frame, Result<BoardView> view)
{
    image.widthPx = frame.format.width;
    image.heightPx = frame.format.height;
    image.orientation = frame.orientation;
    if (!view) {
        image.view.reset();
        image.reason = view.error().why;
        return;
    }
    image.view = std::move(*view);
    std::erase_if(m_images, [&](const BoardImage &before) { return before.source == image.name; });
    const bool isNew = std::ranges::none_of(m_searched, [&](const Searched &before) {
        return before.view && before.name != image.name && repeatsPosition(*image.view, *before.view);
    });
    if (!isNew)
        return;
    if (auto png = greyPng(frame))
        m_images.push_back({image.name, std::move(*png)});
}

void CalibrateJob::searchAgain(Searched &image, const BoardSpec &spec, int orientation)
{
    const auto read = readImage(image.still);
    if (!read)
        return;
    const Frame frame = inOrientation(*read, orientation);
    take(image, frame, findBoard(frame, spec, image.name));
}

void CalibrateJob::settle(const JobControl &control)
{
    if (m_searched.empty())
        return;
    settleOrientation(control);
    settleSize();
    settleBoard(control);
}

namespace {

/// How well images agree on one lens: by how many do, then by their RMS.
struct Agreement
{
    std::size_t images = 0;
    double rmsPx = 0;

    bool operator<(const Agreement &other) const
    {
        return images != other.images ? images < other.images : rmsPx > other.rmsPx;
    }
};

Agreement agreementOf(const std::vector<BoardView> &views, int widthPx, int heightPx,
                      const JobControl &control)
{
    const JobControl quiet{control.cancel, {}};
    const auto fit = calibrateIntrinsics(views, widthPx, heightPx, LensModel::Standard, quiet);
    return fit ? Agreement{fit->imagesUsed(), fit->rmsPx} : Agreement();
}

} // namespace

/// The images of a camera that was turned share the rows and columns of its sensor, and their files say how
/// they are turned; of images that were turned afterwards, the upright ones belong together. Where both may
/// be, those are taken that agree better on one lens.
void CalibrateJob::settleOrientation(const JobControl &control)
{
    std::vector<int> orientations;
    for (const Searched &image : m_searched) {
        if (image.view)
            orientations.push_back(image.orientation);
    }
    if (orientations.empty())
        return;
    const int most = mostFrequent(orientations);
    if (std::ranges::all_of(m_searched, [&](const Searched &one) { return one.orientation == most; }))
        return;
    settleSize();
    const Agreement upright = agreementOf(viewsOfSize(), m_widthPx, m_heightPx, control);
    const std::vector<Searched> uprightImages = m_searched;
    const std::vector<BoardImage> uprightFiles = m_images;
    for (Searched &image : m_searched) {
        if (image.orientation != most && !image.still.empty() && !control.isCancelled())
            searchAgain(image, m_settings.board, most);
    }
    settleSize();
    if (agreementOf(viewsOfSize(), m_widthPx, m_heightPx, control) < upright) {
        m_searched = uprightImages;
        m_images = uprightFiles;
    }
}

/// The size of most images with a board.
void CalibrateJob::settleSize()
{
    std::vector<std::pair<int, int>> all, withBoard;
    for (const Searched &image : m_searched) {
        all.emplace_back(image.widthPx, image.heightPx);
        if (image.view)
            withBoard.push_back(all.back());
    }
    std::tie(m_widthPx, m_heightPx) = mostFrequent(withBoard.empty() ? all : withBoard);
}

std::vector<BoardView> CalibrateJob::viewsOfSize() const
{
    std::vector<BoardView> views;
    for (const Searched &image : m_searched) {
        if (image.view && image.widthPx == m_widthPx && image.heightPx == m_heightPx)
            views.push_back(*image.view);
    }
    return views;
}

void CalibrateJob::settleBoard(const JobControl &control)
{
    BoardSpec &board = m_settings.board;
    const BoardKind most = votedBoard(viewsOfSize(), m_widthPx, m_heightPx);
    if (most.columns == 0)
        return;
    board.pattern = most.pattern;
    if (board.columns == 0) {
        board.columns = most.columns;
        board.rows = most.rows;
    }
    for (Searched &image : m_searched) {
        const bool isRight = image.view && kindOf(*image.view) == most;
        if (isRight || image.widthPx != m_widthPx || image.heightPx != m_heightPx || control.isCancelled())
            continue;
        const std::optional<BoardView> before = image.view;
        if (!image.still.empty()) {
            searchAgain(image, board, image.orientation);
        } else if (before) {
            image.view.reset();
            image.reason = boardOfOtherSize(*before, board);
        }
    }
}

void CalibrateJob::collect()
{
    std::vector<RejectedImage> refused;
    for (Searched &image : m_searched) {
        if (image.widthPx != m_widthPx || image.heightPx != m_heightPx)
            refused.push_back(
                {image.name, otherSizeThanMost(image.widthPx, image.heightPx, m_widthPx, m_heightPx)});
        else if (image.view)
            m_views.push_back(std::move(*image.view));
        else
            refused.push_back({image.name, image.reason});
    }
    m_rejected.insert(m_rejected.begin(), refused.begin(), refused.end());
}

Result<void> CalibrateJob::commit(Project &project)
{
    const auto stored = m_storage->commit(project);
    m_storage.reset(); // if it was not stored, its images go
    if (!stored)
        return tl::unexpected(stored.error());
    return {};
}

} // namespace odo
