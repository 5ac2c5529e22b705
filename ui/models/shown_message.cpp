// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/shown_message.h"

#include "core/base/plain_text.h"
#include "ui/models/shown_names.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace odo {

namespace {

class ShownMessageWords
{
    Q_DECLARE_TR_FUNCTIONS(ShownMessageWords)
};

/// The language of the windows.
class ShownLanguage : public MessageLanguage
{
public:
    std::string words(const MessageText &text) const override
    {
        return QCoreApplication::translate(text.code, text.english).toStdString();
    }
    std::string number(double value, int decimals) const override
    {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        return locale.toString(value, 'f', decimals).toStdString();
    }
    std::string name(const MessageArgument &name) const override
    {
        if (name.kind == MessageArgument::Kind::Team)
            return shownTeam(name.text).toStdString();
        if (name.kind == MessageArgument::Kind::Person)
            return arePseudonymsShown() ? "…" : name.text;
        return plainLine(name.text);
    }
};

QString sentence(QString text)
{
    if (text.isEmpty())
        return text;
    text[0] = text.at(0).toUpper();
    return fullSentence(text);
}

} // namespace

QString breakable(const QString &text)
{
    constexpr int longest = 40;
    const QChar breakHere(0x200b); // zero width space
    QString broken;
    int run = 0;
    for (const QChar c : text) {
        run = c.isSpace() ? 0 : run + 1;
        if (run > longest && !c.isLowSurrogate() && !c.isMark()) {
            broken += breakHere;
            run = 1;
        }
        broken += c;
    }
    return broken;
}

QString shownWords(const Message &message)
{
    return QString::fromStdString(ShownLanguage().render(message));
}

QString joinedWords(const QString &what, const QString &why)
{
    return ShownMessageWords::tr("%1: %2").arg(what, why);
}

QString fullSentence(const QString &words)
{
    static const QString signs = QStringLiteral(".?!。？！");
    return words.isEmpty() || signs.contains(words.back()) ? words : ShownMessageWords::tr("%1.").arg(words);
}

QString errorInWords(const Error &error)
{
    const QString what = shownWords(error.what), why = shownWords(error.why);
    QStringList sentences{sentence(why.isEmpty() ? what : joinedWords(what, why))};
    if (!error.advice.isEmpty())
        sentences << sentence(shownWords(error.advice));
    return sentences.join(QLatin1Char(' '));
}

QString errorLine(const Error &error)
{
    return shownWords(wholeMessage(error));
}

Message imageSubject()
{
    return ODO_TEXT("ui.picture", "the image");
}

Message anotherJobRuns()
{
    return ODO_TEXT("ui.another_job_runs", "another job is running");
}

Message waitOrCancel()
{
    return ODO_TEXT("ui.wait_or_cancel", "wait until it is done, or cancel it");
}

Message noProjectIsOpen()
{
    return ODO_TEXT("ui.no_project_open", "no project is open");
}

Message addCameraWords(const std::string &name)
{
    return ODO_TEXT("ui.add_camera", "add camera %1")(Named::camera(name));
}

Message addRobotWords(std::string robot)
{
    return ODO_TEXT("ui.add_robot", "add robot %1")(Named::robot(std::move(robot)));
}

Message addTaskWords(std::string task)
{
    return ODO_TEXT("ui.add_task", "add task %1")(Named::task(std::move(task)));
}

Message addLayoutWords(std::string layout)
{
    return ODO_TEXT("ui.add_layout", "add layout %1")(Named::layout(std::move(layout)));
}

} // namespace odo
