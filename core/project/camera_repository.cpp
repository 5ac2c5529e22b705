// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/calibration_rows.h"
#include "core/project/connection.h"
#include "core/project/lens_rows.h"
#include "core/project/names.h"
#include "core/project/repositories.h"
#include "core/project/revision_rows.h"
#include "core/project/stored_words.h"

namespace odo {

namespace {

const QString intrinsicsColumns =
    QStringLiteral("SELECT id, camera_id, lens_id, made_ms, origin, rms_px, cross_validation_px, verdict, "
                   "software_version, board_pattern, board_columns, board_rows, square_m, marker_ratio, dictionary, "
                   "lens_reason, disagreeing_part FROM intrinsics ");

CameraRecord cameraOf(const Statement &row)
{
    return {row.integer(0), row.name(1), row.text(2)};
}

Result<IntrinsicsRecord> readIntrinsics(const ProjectConnection &connection, const Statement &row)
{
    IntrinsicsRecord record;
    record.id = row.integer(0);
    record.camera = row.integer(1);
    record.made = Instant(std::chrono::milliseconds(row.integer(3)));
    record.origin = row.text(4);
    record.calibration.rmsPx = row.real(5);
    record.calibration.crossValidationPx = row.real(6);
    record.calibration.verdict = row.text(7);
    auto intrinsics = lens(connection, row.integer(2));
    if (!intrinsics)
        return tl::unexpected(intrinsics.error());
    record.calibration.intrinsics = std::move(*intrinsics);
    record.softwareVersion = row.name(8);
    if (!row.text(9).empty()) {
        const auto pattern =
            fromStoredWord(boardPatternWords, row.text(9), "calibration " + std::to_string(record.id) + " of the project");
        if (!pattern)
            return tl::unexpected(pattern.error());
        record.board.pattern = *pattern;
    }
    record.board.columns = row.smallInteger(10);
    record.board.rows = row.smallInteger(11);
    record.board.squareM = row.real(12);
    record.board.markerRatio = row.real(13);
    record.board.dictionary = row.text(14);
    record.calibration.lensReason = row.text(15);
    record.calibration.disagreeingPart = row.real(16);
    if (auto read = readCalibrationPictures(connection, record); !read)
        return tl::unexpected(read.error());
    return record;
}

} // namespace

CameraRepository::CameraRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<CameraRecord> CameraRepository::add(const CameraRecord &given)
{
    const CameraRecord camera{given.id, normalName(given.name), given.deviceUri};
    return transact(m_connection, [&]() -> Result<CameraRecord> {
        if (auto valid = checkName("camera", camera.name); !valid)
            return tl::unexpected(valid.error());
        if (auto valid = checkText("address of a camera", camera.deviceUri); !valid)
            return tl::unexpected(valid.error());
        if (auto isFree = checkNameIsFree(m_connection, "camera", "camera", camera.name); !isFree)
            return tl::unexpected(isFree.error());
        Statement insert(m_connection, QStringLiteral("INSERT INTO camera (name, device_uri) VALUES (?,?)"));
        if (auto done = insert.bind(camera.name).bind(camera.deviceUri).run(); !done)
            return tl::unexpected(done.error());
        CameraRecord stored = camera;
        stored.id = insert.insertedId();
        return stored;
    });
}

Result<std::vector<CameraRecord>> CameraRepository::all() const
{
    std::vector<CameraRecord> cameras;
    Statement select(m_connection, QStringLiteral("SELECT id, name, device_uri FROM camera ORDER BY id"));
    auto read = select.eachRow([&cameras](const Statement &row) -> Result<void> {
        cameras.push_back(cameraOf(row));
        return {};
    });
    if (!read)
        return tl::unexpected(read.error());
    return cameras;
}

Result<CameraRecord> CameraRepository::find(const std::string &name) const
{
    const auto id = idNamed(m_connection, "camera", name);
    if (!id)
        return tl::unexpected(id.error());
    if (*id == 0)
        return noSuchName(m_connection, "camera", "camera", name);
    return get(*id);
}

Result<CameraRecord> CameraRepository::get(RecordId id) const
{
    Statement select(m_connection, QStringLiteral("SELECT id, name, device_uri FROM camera WHERE id=?"));
    const auto found = select.bind(id).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchId(m_connection, "camera", id);
    return cameraOf(select);
}

Result<void> CameraRepository::setDevice(RecordId camera, const std::string &uri)
{
    if (auto valid = checkText("address of a camera", uri); !valid)
        return valid;
    Statement update(m_connection, QStringLiteral("UPDATE camera SET device_uri=? WHERE id=?"));
    return update.bind(uri).bind(camera).run();
}

Result<void> CameraRepository::removeUnused(RecordId id)
{
    Statement remove(m_connection, QStringLiteral("DELETE FROM camera WHERE id=?"));
    return remove.bind(id).run(); // its references hold it
}

Result<IntrinsicsRecord> CameraRepository::addIntrinsics(const IntrinsicsRecord &intrinsics)
{
    return transact(m_connection, [&]() -> Result<IntrinsicsRecord> {
        const IntrinsicCalibration &calibration = intrinsics.calibration;
        if (auto valid = checkText("origin of a calibration", intrinsics.origin); !valid)
            return tl::unexpected(valid.error());
        const auto lensId = addLens(m_connection, calibration.intrinsics);
        if (!lensId)
            return tl::unexpected(lensId.error());
        Statement insert(
            m_connection,
            QStringLiteral("INSERT INTO intrinsics (camera_id, lens_id, made_ms, origin, rms_px, "
                           "cross_validation_px, verdict, software_version, board_pattern, board_columns, "
                           "board_rows, square_m, marker_ratio, dictionary, lens_reason, disagreeing_part) "
                           "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
        insert.bind(intrinsics.camera).bind(*lensId);
        insert.bind(static_cast<std::int64_t>(intrinsics.made.time_since_epoch().count()))
            .bind(intrinsics.origin);
        insert.bind(calibration.rmsPx).bind(calibration.crossValidationPx).bind(calibration.verdict);
        const BoardSpec &board = intrinsics.board;
        insert.bind(intrinsics.softwareVersion);
        insert.bind(board.pattern ? storedWord(boardPatternWords, *board.pattern) : std::string());
        insert.bind(board.columns).bind(board.rows).bind(board.squareM).bind(board.markerRatio).bind(board.dictionary);
        insert.bind(calibration.lensReason).bind(calibration.disagreeingPart);
        if (auto done = insert.run(); !done)
            return tl::unexpected(done.error());
        IntrinsicsRecord stored = intrinsics;
        stored.id = insert.insertedId();
        Statement newest(m_connection, QStringLiteral("UPDATE camera SET intrinsics_id=NULL WHERE id=?"));
        if (auto done = newest.bind(intrinsics.camera).run(); !done)
            return tl::unexpected(done.error());
        if (auto added = addCalibrationPictures(m_connection, stored); !added)
            return tl::unexpected(added.error());
        return stored;
    });
}

Result<std::optional<IntrinsicsRecord>> CameraRepository::currentIntrinsics(RecordId camera) const
{
    return currentRevision(m_connection, intrinsicsColumns, "intrinsics", camera, readIntrinsics);
}

Result<std::vector<IntrinsicsRecord>> CameraRepository::allIntrinsics(RecordId camera) const
{
    return allRevisions(m_connection, intrinsicsColumns, camera, readIntrinsics);
}

Result<void> CameraRepository::chooseIntrinsics(RecordId intrinsics)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto chosen = this->intrinsics(intrinsics);
        if (!chosen)
            return tl::unexpected(chosen.error());
        Statement update(m_connection, QStringLiteral("UPDATE camera SET intrinsics_id=? WHERE id=?"));
        return update.bind(intrinsics).bind(chosen->camera).run();
    });
}

Result<IntrinsicsRecord> CameraRepository::intrinsics(RecordId id) const
{
    Statement select(m_connection, intrinsicsColumns + QStringLiteral("WHERE id=?"));
    const auto found = select.bind(id).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchId(m_connection, "calibration", id);
    return readIntrinsics(m_connection, select);
}

} // namespace odo
