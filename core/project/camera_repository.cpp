// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/connection.h"
#include "core/project/lens_rows.h"
#include "core/project/names.h"
#include "core/project/repositories.h"

namespace odo {

namespace {

const QString intrinsicsColumns =
    QStringLiteral("SELECT id, camera_id, lens_id, made_ms, origin, rms_px, cross_validation_px, verdict "
                   "FROM intrinsics ");

CameraRecord cameraOf(const Statement &row)
{
    return {row.integer(0), row.text(1), row.text(2)};
}

/// One row of a table that lists pictures: with a number or with a reason.
template <class Value>
Result<void> addPicture(ProjectConnection &connection, const QString &sql, RecordId intrinsics,
                        std::size_t position, const std::string &file, const Value &value)
{
    if (auto valid = checkText("name of a calibration picture", file); !valid)
        return valid;
    Statement insert(connection, sql);
    return insert.bind(intrinsics).bind(static_cast<std::int64_t>(position)).bind(file).bind(value).run();
}

Result<void> addPictures(ProjectConnection &connection, RecordId id, const IntrinsicCalibration &calibration)
{
    for (std::size_t i = 0; i < calibration.pictures.size(); ++i) {
        const CalibrationPicture &picture = calibration.pictures[i];
        if (auto done =
                addPicture(connection, QStringLiteral("INSERT INTO calibration_picture VALUES (?,?,?,?)"), id,
                           i, picture.view.source, picture.rmsPx);
            !done)
            return done;
    }
    for (std::size_t i = 0; i < calibration.rejected.size(); ++i) {
        const RejectedPicture &picture = calibration.rejected[i];
        if (auto done =
                addPicture(connection, QStringLiteral("INSERT INTO rejected_picture VALUES (?,?,?,?)"), id, i,
                           picture.file, picture.reason);
            !done)
            return done;
    }
    return {};
}

Result<void> readPictures(const ProjectConnection &connection, RecordId id, IntrinsicCalibration &into)
{
    Statement used(connection,
                   QStringLiteral("SELECT file, rms_px FROM calibration_picture WHERE intrinsics_id=? "
                                  "ORDER BY position"));
    auto read = used.bind(id).eachRow([&into](const Statement &row) -> Result<void> {
        into.pictures.emplace_back();
        into.pictures.back().view.source = row.text(0);
        into.pictures.back().rmsPx = row.real(1);
        return {};
    });
    if (!read)
        return read;
    Statement rejected(connection,
                       QStringLiteral("SELECT file, reason FROM rejected_picture WHERE intrinsics_id=? "
                                      "ORDER BY position"));
    return rejected.bind(id).eachRow([&into](const Statement &row) -> Result<void> {
        into.rejected.push_back({row.text(0), row.text(1)});
        return {};
    });
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
    if (auto read = readPictures(connection, record.id, record.calibration); !read)
        return tl::unexpected(read.error());
    return record;
}

} // namespace

CameraRepository::CameraRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<CameraRecord> CameraRepository::add(const CameraRecord &camera)
{
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
    Statement select(m_connection, QStringLiteral("SELECT id, name, device_uri FROM camera WHERE name=?"));
    const auto found = select.bind(name).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchName(m_connection, "camera", "camera", name);
    return cameraOf(select);
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
                           "cross_validation_px, verdict) VALUES (?,?,?,?,?,?,?)"));
        insert.bind(intrinsics.camera).bind(*lensId);
        insert.bind(static_cast<std::int64_t>(intrinsics.made.time_since_epoch().count()))
            .bind(intrinsics.origin);
        insert.bind(calibration.rmsPx).bind(calibration.crossValidationPx).bind(calibration.verdict);
        if (auto done = insert.run(); !done)
            return tl::unexpected(done.error());
        IntrinsicsRecord stored = intrinsics;
        stored.id = insert.insertedId();
        if (auto added = addPictures(m_connection, stored.id, calibration); !added)
            return tl::unexpected(added.error());
        return stored;
    });
}

Result<std::optional<IntrinsicsRecord>> CameraRepository::currentIntrinsics(RecordId camera) const
{
    Statement select(m_connection,
                     intrinsicsColumns + QStringLiteral("WHERE camera_id=? ORDER BY id DESC LIMIT 1"));
    const auto found = select.bind(camera).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return std::nullopt;
    auto record = readIntrinsics(m_connection, select);
    if (!record)
        return tl::unexpected(record.error());
    return std::optional(std::move(*record));
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
