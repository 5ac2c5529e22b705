// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/lens_rows.h"

#include "core/project/connection.h"
#include "core/project/names.h"
#include "core/project/series_blobs.h"
#include "core/project/stored_words.h"

namespace odo {

Result<RecordId> addLens(ProjectConnection &connection, const Intrinsics &intrinsics)
{
    Statement insert(connection,
                     QStringLiteral("INSERT INTO lens (width_px, height_px, fx_px, fy_px, cx_px, cy_px, "
                                    "model, distortion, covariance) VALUES (?,?,?,?,?,?,?,?,?)"));
    insert.bind(intrinsics.widthPx).bind(intrinsics.heightPx).bind(intrinsics.fxPx).bind(intrinsics.fyPx);
    insert.bind(intrinsics.cxPx).bind(intrinsics.cyPx).bind(storedWord(lensModelWords, intrinsics.model));
    insert.bind(packNumbers(intrinsics.distortion)).bind(packSquare(intrinsics.covariance));
    if (auto done = insert.run(); !done)
        return tl::unexpected(done.error());
    return insert.insertedId();
}

Result<Intrinsics> lens(const ProjectConnection &connection, RecordId id)
{
    Statement select(connection,
                     QStringLiteral("SELECT width_px, height_px, fx_px, fy_px, cx_px, cy_px, model, "
                                    "distortion, covariance FROM lens WHERE id=?"));
    const auto found = select.bind(id).firstRow();
    if (!found)
        return tl::unexpected(found.error());
    if (!*found)
        return noSuchId(connection, "lens", id);
    const std::string what = "lens " + std::to_string(id) + " of the project";
    const auto model = fromStoredWord(lensModelWords, select.text(6), what);
    if (!model)
        return tl::unexpected(model.error());
    auto distortion = unpackNumbers(select.blob(7), what);
    if (!distortion)
        return tl::unexpected(distortion.error());
    auto covariance = unpackSquare(select.blob(8), what);
    if (!covariance)
        return tl::unexpected(covariance.error());
    Intrinsics intrinsics;
    intrinsics.widthPx = select.smallInteger(0);
    intrinsics.heightPx = select.smallInteger(1);
    intrinsics.fxPx = select.real(2);
    intrinsics.fyPx = select.real(3);
    intrinsics.cxPx = select.real(4);
    intrinsics.cyPx = select.real(5);
    intrinsics.model = *model;
    intrinsics.distortion = std::move(*distortion);
    intrinsics.covariance = std::move(*covariance);
    return intrinsics;
}

} // namespace odo
