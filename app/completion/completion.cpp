// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/completion/completion.h"

#include "app/commands/commands.h"
#include "app/completion/project_names.h"
#include "app/completion/shell_line.h"
#include "app/completion/usage.h"

#include <QRegularExpression>
#include <QSet>
#include <algorithm>
#include <cstdio>

namespace odo {

namespace {

using Files = Completion::Files;

constexpr QStringView projectWord = u"P.odo";

/// Whether the help means this very word, and not what it stands for.
bool isLiteral(const QString &word)
{
    static const QRegularExpression literal(QStringLiteral("^[a-z][A-Za-z0-9_]*$"));
    return literal.match(word).hasMatch();
}

/// The one kind of name that several words of the help stand for.
QString nameKind(QString word)
{
    static const QHash<QString, QString> same{{QStringLiteral("A"), QStringLiteral("CAMERA")},
                                              {QStringLiteral("C"), QStringLiteral("CLASS")},
                                              {QStringLiteral("ROBOT"), QStringLiteral("R")},
                                              {QStringLiteral("T"), QStringLiteral("TEAM")}};
    while (!word.isEmpty() && word.back().isDigit())
        word.chop(1);
    return same.value(word, word);
}

Files filesOf(const QString &word)
{
    static const QRegularExpression fileName(QStringLiteral("^[A-Za-z]+\\.[a-z]+$"));
    if (word == projectWord)
        return Files::Projects;
    if (word == u"DIR" || word == u"FOLDER")
        return Files::Folders;
    static const QStringList files{QStringLiteral("FILE"), QStringLiteral("IMAGE"), QStringLiteral("VIDEO")};
    return files.contains(word) || fileName.match(word).hasMatch() ? Files::Any : Files::None;
}

/// Completes the last word of one call of a command.
class CallCompleter
{
public:
    CallCompleter(CommandSyntax syntax, const QStringList &words)
        : m_syntax(std::move(syntax)), m_forms(usageForms(m_syntax)), m_current(words.last())
    {
        readWords(words.first(words.size() - 1));
        std::erase_if(m_forms, [&](const UsageForm &form) { return !fits(form); });
        findProject();
    }

    Completion complete()
    {
        const auto equals = m_current.indexOf(u'=');
        if (m_option) {
            offerValue(*m_option, {});
        } else if (m_current.startsWith(QStringLiteral("--")) && equals > 0 && !m_isBehindDashes) {
            if (const auto *option = optionNamed(m_syntax, m_current.mid(2, equals - 2)))
                offerValue(*option, m_current.first(equals + 1));
        } else if (m_current.startsWith(u'-') && !m_isBehindDashes) {
            offerOptions();
        } else if (!offerPositional() && m_current.isEmpty()) {
            offerOptions();
        }
        return std::move(m_completion);
    }

private:
    /// Tells positional arguments from options and their values.
    void readWords(const QStringList &words)
    {
        for (const QString &word : words) {
            if (m_option && !(hasOptionalValue() && word.startsWith(u'-'))) {
                m_option = nullptr;
            } else if (m_isBehindDashes || !word.startsWith(u'-') || word == u"-") {
                m_positionals << word;
            } else if (word == u"--") {
                m_isBehindDashes = true;
            } else if (!word.contains(u'=')) {
                m_option = optionNamed(m_syntax, word.mid(word.startsWith(QStringLiteral("--")) ? 2 : 1));
                if (m_option && m_option->valueName().isEmpty())
                    m_option = nullptr;
            }
        }
        if (m_option && hasOptionalValue() && m_current.startsWith(u'-'))
            m_option = nullptr;
    }
    bool hasOptionalValue() const { return m_option->valueName().startsWith(u'['); }

    /// Whether the positional arguments so far may be those of this form.
    bool fits(const UsageForm &form) const
    {
        for (qsizetype i = 0; i < std::min(m_positionals.size(), form.positionals.size()); ++i) {
            const QStringList choices = form.positionals[i].split(u'|');
            if (std::ranges::all_of(choices, isLiteral) && !choices.contains(m_positionals[i]))
                return false;
        }
        return true;
    }

    void findProject()
    {
        for (const UsageForm &form : m_forms) {
            const auto at = form.positionals.indexOf(projectWord);
            if (at >= 0 && at < m_positionals.size())
                m_project = withHome(m_positionals[at]).toStdString();
        }
    }

    void offer(const QString &word, const QString &remark = {})
    {
        if (!word.startsWith(m_current) || m_offered.contains(word))
            return;
        m_offered.insert(word);
        m_completion.candidates.push_back({word, remark});
    }

    void offerOptions()
    {
        for (const QCommandLineOption &option : m_syntax.options)
            offer(QStringLiteral("--") + option.names().constLast(), option.description());
    }

    /// Of a list, the value behind its last comma.
    void offerValue(const QCommandLineOption &option, const QString &before)
    {
        if (option.valueName().endsWith(QStringLiteral("[,...]")))
            offerOneValue(option, m_current.first(std::max(before.size(), m_current.lastIndexOf(u',') + 1)));
        else
            offerOneValue(option, before);
    }

    void offerOneValue(const QCommandLineOption &option, const QString &before)
    {
        for (const UsageForm &form : m_forms)
            offerMeaning(form.valueForms.value(option.names().constLast()), before);
        offerMeaning(option.valueName(), before);
    }

    /// False where no further positional argument belongs there.
    bool offerPositional()
    {
        bool belongs = false;
        for (const UsageForm &form : m_forms) {
            const qsizetype at = m_positionals.size(), count = form.positionals.size();
            if (at >= count && !(form.isLastRepeated && count > 0))
                continue;
            offerMeaning(form.positionals[std::min(at, count - 1)], {});
            belongs = true;
        }
        return belongs;
    }

    /// What a word of the help stands for: "csv|tum", "TRIAL", "CAMERA=FILE". before: what comes before it in
    /// the word that is completed.
    void offerMeaning(const QString &meaning, const QString &before)
    {
        for (const QString &word : meaning.split(u'|', Qt::SkipEmptyParts)) {
            const auto equals = word.indexOf(u'=');
            if (equals < 0) {
                offerOne(word, before, {});
                continue;
            }
            const auto typed = m_current.indexOf(u'=', before.size());
            if (typed < 0)
                offerOne(word.first(equals), before, QStringLiteral("="));
            else
                offerOne(word.mid(equals + 1), m_current.first(typed + 1), {});
        }
    }

    void offerOne(const QString &word, const QString &before, const QString &behind)
    {
        if (isLiteral(word))
            offer(before + word + behind);
        else if (const Files files = filesOf(word); files != Files::None)
            m_completion.files = files;
        else if (!m_project.empty())
            namesInProject(m_project, nameKind(word), [&](const QString &name, const QString &remark) {
                offer(before + name + behind, remark);
            });
    }

    const CommandSyntax m_syntax;
    std::vector<UsageForm> m_forms; ///< those that fit what is there
    const QString m_current;
    QStringList m_positionals;
    const QCommandLineOption *m_option = nullptr; ///< whose value is the current word
    bool m_isBehindDashes = false;
    std::filesystem::path m_project;
    Completion m_completion;
    QSet<QString> m_offered; ///< in it
};

void offerCommands(const QString &begun, Completion &completion)
{
    for (const NamedCommand &command : allCommands())
        if (const QString name = QString::fromLatin1(command.name); name.startsWith(begun))
            completion.candidates.push_back({name, QString::fromLatin1(command.summary)});
}

Completion ofFirstWord(const QString &begun)
{
    Completion completion;
    completion.files = Files::Projects;
    offerCommands(begun, completion);
    for (const auto &[word, remark] : {std::pair("help", "show the commands, or the options of one"),
                                       {"--help", "show the commands"},
                                       {"--version", "print the version"},
                                       {"--window", "open the workbench and report problems there"}})
        if (const QString name = QString::fromLatin1(word);
            name.startsWith(begun) && (begun.startsWith(u'-') || !name.startsWith(u'-')))
            completion.candidates.push_back({name, QString::fromLatin1(remark)});
    return completion;
}

const char *wordOf(Files files)
{
    switch (files) {
    case Files::Any:
        return "files";
    case Files::Folders:
        return "folders";
    case Files::Projects:
        return "projects";
    case Files::None:
        break;
    }
    return "none";
}

void printLine(const QString &line)
{
    std::puts(line.toUtf8().constData());
}

bool answerBash(const QStringList &arguments)
{
    if (arguments.size() != 2)
        return false;
    const ShellLine line = readShellLine(arguments[0], arguments[1]);
    if (line.words.size() < 2)
        return false;
    const Completion completion = completionOf(line.words.mid(1));
    std::puts(wordOf(completion.files));
    printLine(line.words.last().mid(line.keptLength));
    for (const Completion::Candidate &each : completion.candidates)
        printLine(quotedForShell(each.word.mid(line.keptLength), line.quote));
    return true;
}

} // namespace

Completion completionOf(const QStringList &words)
{
    if (words.size() < 2)
        return ofFirstWord(words.value(0));
    Completion completion;
    if (words.first() == u"help" && words.size() == 2) {
        offerCommands(words.last(), completion);
    } else if (words.first() == u"--window" && words.size() == 2) {
        completion.files = Files::Projects;
    } else {
        for (const NamedCommand &command : allCommands())
            if (words.first() == QLatin1String(command.name))
                return CallCompleter(syntaxOf(command.run), words.mid(1)).complete();
    }
    return completion;
}

bool answerCompletion(const QStringList &arguments)
{
    if (arguments.value(0) == u"bash")
        return answerBash(arguments.mid(1));
    if (arguments.value(0) != u"words" || arguments.size() < 2)
        return false;
    const Completion completion = completionOf(arguments.mid(1));
    std::puts(wordOf(completion.files));
    for (const Completion::Candidate &each : completion.candidates)
        printLine(each.remark.isEmpty() ? each.word : each.word + u'\t' + each.remark);
    return true;
}

} // namespace odo
