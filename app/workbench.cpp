// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workbench.h"

#include "core/base/platform/crash_handler.h"
#include "core/base/platform/user_folders.h"
#include "core/files/output_file.h"
#include "core/project/project.h"
#include "ui/main_window/language.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/paint_window.h"
#include "ui/main_window/program_ends.h"
#include "ui/main_window/workspace.h"
#include "ui/models/trial_scene.h"
#include "ui/views/widgets/theme.h"

#include <QApplication>
#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QImageWriter>
#include <QSettings>
#include <QTemporaryDir>
#include <new>

namespace odo {

void runWorkbench(const std::optional<std::filesystem::path> &project)
{
    installLanguage(*qApp, chosenLanguage());
    applyAppearance(*qApp);
    MainWindow window;
    QObject::connect(&window.workspace(), &Workspace::opened, &window,
                     [&window] { noteOpenProject(window.workspace().project()->file()); });
    const StopRequests stopRequests(window);
    window.show();
    reportCrashes(window, stateFolder(), project);
    if (project)
        window.beginOpening(*project);
    QApplication::exec();
}

Result<void> paintWorkbench(const std::filesystem::path &project, const std::string &trial, WindowMode mode,
                            QSize size, const OutputTarget &image, const CancelToken &cancel)
{
    applyAppearance(*qApp);
    const Message what = ODO_TEXT("app.picture", "image '%1'")(Named::file(image.file));
    const QByteArray format =
        QFileInfo(QString::fromStdString(image.file.string())).suffix().toLatin1().toLower();
    if (!QImageWriter::supportedImageFormats().contains(format))
        return fail(ErrorCode::WrongCall, what,
                    ODO_TEXT("app.picture_format_unknown", "its format is not supported"),
                    ODO_TEXT("app.end_in_png_or_jpg", "give it a name that ends in .png or .jpg"));
    // The user's preferences must neither change the image nor be changed.
    const QTemporaryDir preferences;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, preferences.path());
    MainWindow window;
    ODO_TRY(window.openProject(project));
    // The window would report the problem, and be painted all the same.
    ODO_TRY(loadTrialScene(*window.workspace().project(), trial));
    if (cancel.isCancelled())
        return cancelled(what);
    ODO_TRY(window.showTrial(trial));
    if (mode == WindowMode::Compare) {
        ODO_TRY(window.compareTrials({QString::fromStdString(trial)}));
    } else {
        window.showMode(mode);
    }
    const QImage painted = cancel.isCancelled() ? QImage() : paintWindow(window, size, cancel);
    if (cancel.isCancelled())
        return cancelled(what);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!painted.save(&buffer, format.constData())) // which nothing else keeps it from
        throw std::bad_alloc();
    return writeOutput(image, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace odo
