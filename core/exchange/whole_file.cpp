// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/whole_file.h"

#include "core/files/temporary.h"

#include <QFileInfo>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace odo {

bool WholeFile::commit()
{
    const bool isWritten = flush() && error() == NoError;
    if (isWritten && ::fsync(handle()) == 0) {
        if (!QSaveFile::commit())
            return false;
        syncToDisk(QFileInfo(fileName()).absolutePath().toStdString()); // some file systems cannot: the bytes are safe
        return true;
    }
    const QString why = isWritten ? QString::fromLocal8Bit(std::strerror(errno)) : errorString();
    cancelWriting();
    QSaveFile::commit(); // removes it
    setErrorString(why);
    return false;
}

} // namespace odo
