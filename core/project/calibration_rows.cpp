// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/calibration_rows.h"

#include "core/project/connection.h"
#include "core/project/names.h"
#include "core/project/recording_rows.h"
#include "core/project/series_blobs.h"

namespace odo {

namespace {

Result<void> addUsed(ProjectConnection &connection, const IntrinsicsRecord &record, std::size_t position)
{
    const CalibrationPicture &picture = record.calibration.pictures[position];
    const StoredPicture file = position < record.files.size() ? record.files[position] : StoredPicture{};
    if (auto valid = checkText("name of a calibration picture", picture.view.source); !valid)
        return valid;
    if (auto valid = checkText("path of a calibration picture", file.path); !valid)
        return valid;
    const std::filesystem::path path(file.path);
    Statement insert(connection, QStringLiteral("INSERT INTO calibration_picture (intrinsics_id, position, file, rms_px, "
                                                "used, corners, path, sha256, bytes) VALUES (?,?,?,?,?,?,?,?,?)"));
    insert.bind(record.id).bind(static_cast<std::int64_t>(position)).bind(picture.view.source).bind(picture.rmsPx);
    insert.bind(picture.used ? 1 : 0).bind(packCorners(picture));
    insert.bind(path.is_absolute() ? storedPath(connection.file(), path) : file.path);
    return insert.bind(file.sha256).bind(file.bytes).run();
}

Result<void> addRejected(ProjectConnection &connection, const IntrinsicsRecord &record, std::size_t position)
{
    const RejectedPicture &picture = record.calibration.rejected[position];
    if (auto valid = checkText("name of a calibration picture", picture.file); !valid)
        return valid;
    Statement insert(connection, QStringLiteral("INSERT INTO rejected_picture VALUES (?,?,?,?)"));
    insert.bind(record.id).bind(static_cast<std::int64_t>(position)).bind(picture.file);
    return insert.bind(picture.reason).run();
}

} // namespace

Result<void> addCalibrationPictures(ProjectConnection &connection, const IntrinsicsRecord &record)
{
    for (std::size_t i = 0; i < record.calibration.pictures.size(); ++i) {
        if (auto done = addUsed(connection, record, i); !done)
            return done;
    }
    for (std::size_t i = 0; i < record.calibration.rejected.size(); ++i) {
        if (auto done = addRejected(connection, record, i); !done)
            return done;
    }
    return {};
}

Result<void> readCalibrationPictures(const ProjectConnection &connection, IntrinsicsRecord &into)
{
    Statement used(connection, QStringLiteral("SELECT file, rms_px, used, corners, path, sha256, bytes FROM "
                                              "calibration_picture WHERE intrinsics_id=? ORDER BY position"));
    auto read = used.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        CalibrationPicture picture;
        picture.view.source = row.text(0);
        picture.view.columns = into.board.columns;
        picture.view.rows = into.board.rows;
        picture.view.pattern = into.board.pattern.value_or(BoardPattern::Checkerboard);
        picture.rmsPx = row.real(1);
        picture.used = row.integer(2) != 0;
        if (const QByteArray corners = row.blob(3); !corners.isEmpty()) {
            if (auto unpacked = unpackCorners(corners, "corners of '" + picture.view.source + "'", picture); !unpacked)
                return unpacked;
        }
        into.calibration.pictures.push_back(std::move(picture));
        into.files.push_back({row.text(4), row.text(5), row.integer(6)});
        return {};
    });
    if (!read)
        return read;
    Statement rejected(connection,
                       QStringLiteral("SELECT file, reason FROM rejected_picture WHERE intrinsics_id=? "
                                      "ORDER BY position"));
    return rejected.bind(into.id).eachRow([&into](const Statement &row) -> Result<void> {
        into.calibration.rejected.push_back({row.text(0), row.text(1)});
        return {};
    });
}

} // namespace odo
