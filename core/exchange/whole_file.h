// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSaveFile>

namespace odo {

/// A QSaveFile that takes its name only with all its bytes on the disk. QSaveFile::commit() (Qt 6.4) does not look whether the
/// last bytes, which wait in a buffer until then, could be written, nor whether the disk could keep them. One thread.
class WholeFile : public QSaveFile
{
public:
    using QSaveFile::QSaveFile;

    /// False where any of it failed: under the name there is then what was there before, and errorString() says why.
    bool commit();
};

} // namespace odo
