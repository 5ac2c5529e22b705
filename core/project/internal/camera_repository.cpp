// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/intrinsics_influence.h"
#include "core/project/internal/calibration_rows.h"
#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/recording_rows.h"
#include "core/project/records.h"
#include "core/project/repositories.h"

#include <optional>
#include <vector>

namespace odo {

// Of a camera's calibrations, and likewise of its registrations, every revision stays; the newest is in force
// unless a person has chosen another one. A choice of another camera's, which only a hand in the database can
// make, is none; checkDerivedMetrics names it. table: "intrinsics" or "registration", whose rows have a
// camera_id, and for which camera has a column that names the chosen one. columns: a SELECT up to its WHERE.
// On the project's thread.

/// Makes a record of a row.
template <class Record>
using RowReader = Result<Record> (*)(const ProjectConnection &, const Statement &);

/// The one in force; nullopt: there is none.
template <class Record>
Result<std::optional<Record>> currentRevision(const ProjectConnection &connection, const QString &columns,
                                              const char *table, RecordId camera, RowReader<Record> read)
{
    Statement select(
        connection,
        columns +
            QStringLiteral(
                "WHERE id=COALESCE((SELECT chosen.id FROM camera JOIN %1 AS chosen ON chosen.id=camera.%1_id "
                "AND chosen.camera_id=camera.id WHERE camera.id=?), (SELECT MAX(id) FROM %1 WHERE "
                "camera_id=?))")
                .arg(QLatin1String(table)));
    const auto found = ODO_TRY(select.bind(camera).bind(camera).firstRow());
    if (!found)
        return std::nullopt;
    auto record = ODO_TRY(read(connection, select));
    return std::optional(std::move(record));
}

/// The newest first.
template <class Record>
Result<std::vector<Record>> allRevisions(const ProjectConnection &connection, const QString &columns,
                                         RecordId camera, RowReader<Record> read)
{
    std::vector<Record> all;
    Statement select(connection, columns + QStringLiteral("WHERE camera_id=? ORDER BY id DESC"));
    auto done = select.bind(camera).eachRow([&](const Statement &row) -> Result<void> {
        all.push_back(ODO_TRY(read(connection, row)));
        return {};
    });
    if (!done)
        return tl::unexpected(done.error());
    return all;
}

namespace {

const QString intrinsicsColumns = QStringLiteral(
    "SELECT id, camera_id, lens_id, made_ms, origin, rms_px, cross_validation_px, verdict, "
    "software_version, board_pattern, board_columns, board_rows, square_m, marker_ratio, dictionary, "
    "lens_reason, disagreeing_part FROM intrinsics ");

Message cameraAddress()
{
    return ODO_TEXT("project.camera_address", "address of a camera");
}

Message registrationOfProject(RecordId id)
{
    return ODO_TEXT("project.registration_of_project", "registration %1 of the project")(id);
}

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
    record.origin = row.message(4);
    record.calibration.rmsPx = row.real(5);
    record.calibration.crossValidationPx = row.real(6);
    record.calibration.verdict = row.message(7);
    auto intrinsics = ODO_TRY(lens(connection, row.integer(2)));
    record.calibration.intrinsics = std::move(intrinsics);
    record.softwareVersion = row.name(8);
    if (!row.text(9).empty()) {
        const auto pattern = ODO_TRY(fromStoredWord(
            boardPatternWords, row.text(9),
            ODO_TEXT("project.calibration_of_project", "calibration %1 of the project")(record.id)));
        record.board.pattern = pattern;
    }
    record.board.columns = row.smallInteger(10);
    record.board.rows = row.smallInteger(11);
    record.board.squareM = row.real(12);
    record.board.markerRatio = row.real(13);
    record.board.dictionary = row.text(14);
    record.calibration.modelReason = row.message(15);
    record.calibration.disagreeingPart = row.real(16);
    ODO_TRY(readCalibrationImages(connection, record));
    return record;
}

} // namespace

CameraRepository::CameraRepository(ProjectConnection &connection) : m_connection(connection) {}

Result<CameraRecord> CameraRepository::add(const CameraRecord &given)
{
    const CameraRecord camera{given.id, normalName(given.name), given.deviceUri};
    return transact(m_connection, [&]() -> Result<CameraRecord> {
        ODO_TRY(checkName(RecordKind::Camera, camera.name));
        ODO_TRY(checkText(cameraAddress(), camera.deviceUri));
        ODO_TRY(checkNameIsFree(m_connection, RecordKind::Camera, camera.name));
        Statement insert(m_connection, QStringLiteral("INSERT INTO camera (name, device_uri) VALUES (?,?)"));
        ODO_TRY(insert.bind(camera.name).bind(camera.deviceUri).run());
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
    const auto id = ODO_TRY(idNamed(m_connection, RecordKind::Camera, name));
    if (id == 0)
        return noSuchName(m_connection, RecordKind::Camera, name);
    return get(id);
}

Result<CameraRecord> CameraRepository::get(RecordId id) const
{
    Statement select(m_connection, QStringLiteral("SELECT id, name, device_uri FROM camera WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Camera, id);
    return cameraOf(select);
}

Result<void> CameraRepository::setDevice(RecordId camera, const std::string &uri)
{
    ODO_TRY(checkText(cameraAddress(), uri));
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
        ODO_TRY(checkText(ODO_TEXT("project.calibration_origin", "origin of a calibration"),
                          intrinsics.origin.english()));
        const auto intrinsicsId = ODO_TRY(storeIntrinsics(m_connection, calibration.intrinsics));
        Statement insert(
            m_connection,
            QStringLiteral("INSERT INTO intrinsics (camera_id, lens_id, made_ms, origin, rms_px, "
                           "cross_validation_px, verdict, software_version, board_pattern, board_columns, "
                           "board_rows, square_m, marker_ratio, dictionary, lens_reason, disagreeing_part) "
                           "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
        insert.bind(intrinsics.camera).bind(intrinsicsId);
        insert.bind(static_cast<std::int64_t>(intrinsics.made.time_since_epoch().count()))
            .bind(intrinsics.origin);
        insert.bind(calibration.rmsPx).bind(calibration.crossValidationPx).bind(calibration.verdict);
        const BoardSpec &board = intrinsics.board;
        insert.bind(intrinsics.softwareVersion);
        insert.bind(board.pattern ? storedWord(boardPatternWords, *board.pattern) : std::string());
        insert.bind(board.columns)
            .bind(board.rows)
            .bind(board.squareM)
            .bind(board.markerRatio)
            .bind(board.dictionary);
        insert.bind(calibration.modelReason).bind(calibration.disagreeingPart);
        ODO_TRY(insert.run());
        IntrinsicsRecord stored = intrinsics;
        stored.id = insert.insertedId();
        Statement newest(m_connection, QStringLiteral("UPDATE camera SET intrinsics_id=NULL WHERE id=?"));
        ODO_TRY(newest.bind(intrinsics.camera).run());
        ODO_TRY(addCalibrationImages(m_connection, stored));
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
        const auto chosen = ODO_TRY(this->intrinsics(intrinsics));
        Statement update(m_connection, QStringLiteral("UPDATE camera SET intrinsics_id=? WHERE id=?"));
        return update.bind(intrinsics).bind(chosen.camera).run();
    });
}

Result<IntrinsicsRecord> CameraRepository::intrinsics(RecordId id) const
{
    Statement select(m_connection, intrinsicsColumns + QStringLiteral("WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Calibration, id);
    return readIntrinsics(m_connection, select);
}

// The registrations of CameraRepository.

namespace {

const QString registrationColumns = QStringLiteral(
    "SELECT id, camera_id, layout_id, intrinsics_id, assumed_lens_id, made_ms, qw, qx, qy, qz, "
    "x_m, y_m, z_m, pose_covariance, rms_px, rms_m, verdict, software_version, picture_path, picture_sha256, "
    "picture_bytes, upright FROM registration ");

Result<RecordId> addRow(ProjectConnection &connection, const RegistrationRecord &record,
                        RecordId intrinsicsId)
{
    ODO_TRY(checkText(ODO_TEXT("project.registration_picture_path", "path of a registration's image"),
                      record.image.path));
    Statement insert(
        connection,
        QStringLiteral("INSERT INTO registration (camera_id, layout_id, intrinsics_id, assumed_lens_id, "
                       "made_ms, qw, qx, qy, qz, x_m, y_m, z_m, pose_covariance, rms_px, rms_m, verdict, "
                       "software_version, picture_path, picture_sha256, picture_bytes, upright) "
                       "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)"));
    const FloorRegistration &registration = record.registration;
    const Eigen::Quaterniond &q = registration.worldFromCamera.rotation;
    const Eigen::Vector3d &t = registration.worldFromCamera.translation;
    insert.bind(record.camera).bind(record.layout).bindReference(record.intrinsics).bind(intrinsicsId);
    insert.bind(static_cast<std::int64_t>(record.made.time_since_epoch().count()));
    insert.bind(q.w()).bind(q.x()).bind(q.y()).bind(q.z()).bind(t.x()).bind(t.y()).bind(t.z());
    insert.bind(packSquare(registration.poseCovariance)).bind(registration.rmsPx).bind(registration.rmsM);
    insert.bind(registration.verdict).bind(record.softwareVersion);
    const StoredImage &image = record.image;
    const std::filesystem::path path(image.path);
    insert.bind(path.is_absolute() ? storedPath(connection.file(), path) : image.path)
        .bind(image.sha256)
        .bind(image.bytes);
    ODO_TRY(insert.bind(record.isUpright ? 1 : 0).run());
    return insert.insertedId();
}

Result<void> addMarkers(ProjectConnection &connection, RecordId id, const RegistrationRecord &record)
{
    for (std::size_t i = 0; i < record.pixels.size(); ++i) {
        const MarkerPixel &marker = record.pixels[i];
        ODO_TRY(checkName(RecordKind::Marker, marker.label));
        Statement insert(connection, QStringLiteral("INSERT INTO registration_pixel VALUES (?,?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(marker.label);
        ODO_TRY(insert.bind(marker.pixel.x()).bind(marker.pixel.y()).run());
    }
    for (std::size_t i = 0; i < record.registration.markers.size(); ++i) {
        const MarkerError &marker = record.registration.markers[i];
        ODO_TRY(checkName(RecordKind::Marker, marker.label));
        Statement insert(connection, QStringLiteral("INSERT INTO registration_error VALUES (?,?,?,?,?)"));
        insert.bind(id).bind(static_cast<std::int64_t>(i)).bind(marker.label);
        ODO_TRY(insert.bind(marker.errorM).bind(marker.errorPx).run());
    }
    return {};
}

Result<void> readMarkers(const ProjectConnection &connection, RegistrationRecord &into)
{
    Statement pixels(connection, QStringLiteral("SELECT label, u_px, v_px FROM registration_pixel "
                                                "WHERE registration_id=? ORDER BY position"));
    auto read = pixels.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.pixels.push_back({row.name(0), {row.real(1), row.real(2)}});
        return {};
    });
    if (!read)
        return read;
    Statement errors(connection, QStringLiteral("SELECT label, error_m, error_px FROM registration_error "
                                                "WHERE registration_id=? ORDER BY position"));
    return errors.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.registration.markers.push_back({row.name(0), row.real(1), row.real(2)});
        return {};
    });
}

Result<void> readLastCheck(const ProjectConnection &connection, RegistrationRecord &into)
{
    Statement select(
        connection,
        QStringLiteral("SELECT made_ms, outcome, shift_px, shift_m, words FROM registration_check "
                       "WHERE registration_id=? ORDER BY id DESC LIMIT 1"));
    const auto found = ODO_TRY(select.bind(into.id).firstRow());
    if (!found)
        return {};
    const auto outcome =
        ODO_TRY(fromStoredWord(checkOutcomeWords, select.text(1), registrationOfProject(into.id)));
    into.lastCheck = RegistrationCheck{Instant(std::chrono::milliseconds(select.integer(0))), outcome,
                                       select.real(2), select.real(3), select.message(4)};
    return {};
}

/// Not stored, since it follows from the rest: registrations made by older versions have it too.
Result<void> addFloorSigma(const ProjectConnection &connection, RegistrationRecord &record)
{
    Intrinsics used = record.assumedIntrinsics;
    if (record.intrinsics != 0) {
        Statement select(connection, QStringLiteral("SELECT lens_id FROM intrinsics WHERE id=?"));
        const auto found = ODO_TRY(select.bind(record.intrinsics).firstRow());
        used = ODO_TRY(lens(connection, found ? select.integer(0) : 0));
    }
    if (const auto camera = CameraModel::create(std::move(used)))
        record.registration.floorSigmaM = floorSigmaM(record.registration, *camera, record.pixels);
    return {};
}

Result<RegistrationRecord> readRegistration(const ProjectConnection &connection, const Statement &row)
{
    RegistrationRecord record;
    record.id = row.integer(0);
    record.camera = row.integer(1);
    record.layout = row.integer(2);
    record.intrinsics = row.integer(3);
    record.made = Instant(std::chrono::milliseconds(row.integer(5)));
    FloorRegistration &registration = record.registration;
    registration.worldFromCamera.rotation = {row.real(6), row.real(7), row.real(8), row.real(9)};
    registration.worldFromCamera.translation = {row.real(10), row.real(11), row.real(12)};
    registration.rmsPx = row.real(14);
    registration.rmsM = row.real(15);
    registration.verdict = row.message(16);
    record.softwareVersion = row.name(17);
    record.image = {row.text(18), row.text(19), row.integer(20)};
    record.isUpright = row.integer(21) != 0;
    const Message what = registrationOfProject(record.id);
    const auto covariance = ODO_TRY(unpackSquare(row.blob(13), what));
    if (covariance.rows() != 6)
        return fail(ErrorCode::InvalidInput, what,
                    ODO_TEXT("project.covariance_not_6_by_6", "its stored covariance is not a 6 by 6 matrix"),
                    isDamagedRestoreFile());
    registration.poseCovariance = covariance;
    record.assumedIntrinsics = ODO_TRY(lens(connection, row.integer(4)));
    ODO_TRY(readMarkers(connection, record));
    ODO_TRY(readLastCheck(connection, record));
    ODO_TRY(addFloorSigma(connection, record));
    return record;
}

} // namespace

Result<RegistrationRecord> CameraRepository::addRegistration(const RegistrationRecord &registration)
{
    return transact(m_connection, [&]() -> Result<RegistrationRecord> {
        const auto intrinsicsId = ODO_TRY(storeIntrinsics(m_connection, registration.assumedIntrinsics));
        const auto id = ODO_TRY(addRow(m_connection, registration, intrinsicsId));
        ODO_TRY(addMarkers(m_connection, id, registration));
        Statement newest(m_connection, QStringLiteral("UPDATE camera SET registration_id=NULL WHERE id=?"));
        ODO_TRY(newest.bind(registration.camera).run());
        RegistrationRecord stored = registration;
        stored.id = id;
        return stored;
    });
}

Result<std::optional<RegistrationRecord>> CameraRepository::currentRegistration(RecordId camera) const
{
    return currentRevision(m_connection, registrationColumns, "registration", camera, readRegistration);
}

Result<std::vector<RegistrationRecord>> CameraRepository::allRegistrations(RecordId camera) const
{
    return allRevisions(m_connection, registrationColumns, camera, readRegistration);
}

Result<void> CameraRepository::chooseRegistration(RecordId registration)
{
    return transact(m_connection, [&]() -> Result<void> {
        const auto chosen = ODO_TRY(this->registration(registration));
        Statement update(m_connection, QStringLiteral("UPDATE camera SET registration_id=? WHERE id=?"));
        return update.bind(registration).bind(chosen.camera).run();
    });
}

Result<void> CameraRepository::addCheck(RecordId registration, const RegistrationCheck &check)
{
    return transact(m_connection, [&]() -> Result<void> {
        Statement insert(
            m_connection,
            QStringLiteral("INSERT INTO registration_check (registration_id, made_ms, outcome, shift_px, "
                           "shift_m, words) VALUES (?,?,?,?,?,?)"));
        insert.bind(registration).bind(static_cast<std::int64_t>(check.made.time_since_epoch().count()));
        insert.bind(storedWord(checkOutcomeWords, check.outcome)).bind(check.shiftPx).bind(check.shiftM);
        return insert.bind(check.words).run();
    });
}

Result<RegistrationRecord> CameraRepository::registration(RecordId id) const
{
    Statement select(m_connection, registrationColumns + QStringLiteral("WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(m_connection, RecordKind::Registration, id);
    return readRegistration(m_connection, select);
}

} // namespace odo
