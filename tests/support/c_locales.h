// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QTemporaryDir>
#include <clocale>
#include <string>

namespace odo::test {

/// Locales of the C library made for this program alone (Debian's package locales has what they are made of),
/// so that a test sees their decimal commas and dotless i on any machine. Tests of one thread only.
class CLocales
{
public:
    CLocales() { qputenv("LOCPATH", m_folder.path().toLocal8Bit()); }
    ~CLocales() { std::setlocale(LC_ALL, "C"); }
    Q_DISABLE_COPY_MOVE(CLocales)

    /// "de_DE". False where it cannot be made.
    bool use(const std::string &name)
    {
        const QString full = QString::fromStdString(name + ".UTF-8");
        QProcess::execute(QStringLiteral("localedef"),
                          {QStringLiteral("--no-archive"), QStringLiteral("-i"), QString::fromStdString(name),
                           QStringLiteral("-f"), QStringLiteral("UTF-8"), m_folder.filePath(full)});
        return std::setlocale(LC_ALL, full.toLocal8Bit().constData()) &&
               std::string(std::localeconv()->decimal_point) == ",";
    }

private:
    QTemporaryDir m_folder;
};

} // namespace odo::test
