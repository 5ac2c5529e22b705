// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/internal/calibration_rows.h"

#include "core/project/internal/connection.h"
#include "core/project/internal/series_blobs.h"
#include "core/project/internal/words.h"
#include "core/project/names.h"
#include "core/project/recording_rows.h"

namespace odo {

namespace {

Message imageName()
{
    return ODO_TEXT("project.picture_name", "name of a calibration image");
}

Result<void> addUsed(ProjectConnection &connection, const IntrinsicsRecord &record, std::size_t position)
{
    const CalibrationImage &image = record.calibration.images[position];
    const StoredImage file = position < record.files.size() ? record.files[position] : StoredImage{};
    ODO_TRY(checkText(imageName(), image.view.source));
    ODO_TRY(checkText(ODO_TEXT("project.picture_path", "path of a calibration image"), file.path));
    const std::filesystem::path path(file.path);
    Statement insert(connection,
                     QStringLiteral("INSERT INTO calibration_picture (intrinsics_id, position, file, rms_px, "
                                    "used, corners, path, sha256, bytes) VALUES (?,?,?,?,?,?,?,?,?)"));
    insert.bind(record.id)
        .bind(static_cast<std::int64_t>(position))
        .bind(image.view.source)
        .bind(image.rmsPx);
    insert.bind(image.used ? 1 : 0).bind(packCorners(image));
    insert.bind(path.is_absolute() ? storedPath(connection.file(), path) : file.path);
    return insert.bind(file.sha256).bind(file.bytes).run();
}

Result<void> addRejected(ProjectConnection &connection, const IntrinsicsRecord &record, std::size_t position)
{
    const RejectedImage &image = record.calibration.rejected[position];
    ODO_TRY(checkText(imageName(), image.file));
    Statement insert(connection, QStringLiteral("INSERT INTO rejected_picture VALUES (?,?,?,?)"));
    insert.bind(record.id).bind(static_cast<std::int64_t>(position)).bind(image.file);
    return insert.bind(image.reason).run();
}

} // namespace

Result<void> addCalibrationImages(ProjectConnection &connection, const IntrinsicsRecord &record)
{
    for (std::size_t i = 0; i < record.calibration.images.size(); ++i)
        ODO_TRY(addUsed(connection, record, i));
    for (std::size_t i = 0; i < record.calibration.rejected.size(); ++i)
        ODO_TRY(addRejected(connection, record, i));
    return {};
}

Result<void> readCalibrationImages(const ProjectConnection &connection, IntrinsicsRecord &into)
{
    Statement used(connection, QStringLiteral("SELECT file, rms_px, used, corners, path, sha256, bytes FROM "
                                              "calibration_picture WHERE intrinsics_id=? ORDER BY position"));
    auto read = used.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        CalibrationImage image;
        image.view.source = row.text(0);
        image.view.columns = into.board.columns;
        image.view.rows = into.board.rows;
        image.view.pattern = into.board.pattern.value_or(BoardPattern::Checkerboard);
        image.rmsPx = row.real(1);
        image.used = row.integer(2) != 0;
        if (const QByteArray corners = row.blob(3); !corners.isEmpty()) {
            ODO_TRY(unpackCorners(
                corners, ODO_TEXT("project.corners_of", "corners of '%1'")(Named::file(image.view.source)),
                image));
        }
        into.calibration.images.push_back(std::move(image));
        into.files.push_back({row.text(4), row.text(5), row.integer(6)});
        return {};
    });
    if (!read)
        return read;
    Statement rejected(connection,
                       QStringLiteral("SELECT file, reason FROM rejected_picture WHERE intrinsics_id=? "
                                      "ORDER BY position"));
    return rejected.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.calibration.rejected.push_back({row.text(0), row.message(1)});
        return {};
    });
}

Result<RecordId> storeIntrinsics(ProjectConnection &connection, const Intrinsics &intrinsics)
{
    Statement insert(connection,
                     QStringLiteral("INSERT INTO lens (width_px, height_px, fx_px, fy_px, cx_px, cy_px, "
                                    "model, distortion, covariance) VALUES (?,?,?,?,?,?,?,?,?)"));
    insert.bind(intrinsics.widthPx).bind(intrinsics.heightPx).bind(intrinsics.fxPx).bind(intrinsics.fyPx);
    insert.bind(intrinsics.cxPx).bind(intrinsics.cyPx).bind(storedWord(lensModelWords, intrinsics.model));
    insert.bind(packNumbers(intrinsics.distortion)).bind(packSquare(intrinsics.covariance));
    ODO_TRY(insert.run());
    return insert.insertedId();
}

Result<Intrinsics> lens(const ProjectConnection &connection, RecordId id)
{
    Statement select(connection,
                     QStringLiteral("SELECT width_px, height_px, fx_px, fy_px, cx_px, cy_px, model, "
                                    "distortion, covariance FROM lens WHERE id=?"));
    const auto found = ODO_TRY(select.bind(id).firstRow());
    if (!found)
        return noSuchId(connection, RecordKind::Intrinsics, id);
    const Message what = ODO_TEXT("project.lens_of_project", "lens calibration %1 of the project")(id);
    const auto model = ODO_TRY(fromStoredWord(lensModelWords, select.text(6), what));
    auto distortion = ODO_TRY(unpackNumbers(select.blob(7), what));
    auto covariance = ODO_TRY(unpackSquare(select.blob(8), what));
    Intrinsics intrinsics;
    intrinsics.widthPx = select.smallInteger(0);
    intrinsics.heightPx = select.smallInteger(1);
    intrinsics.fxPx = select.real(2);
    intrinsics.fyPx = select.real(3);
    intrinsics.cxPx = select.real(4);
    intrinsics.cyPx = select.real(5);
    intrinsics.model = model;
    intrinsics.distortion = std::move(distortion);
    intrinsics.covariance = std::move(covariance);
    return intrinsics;
}

} // namespace odo
