// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/platform/sleep_inhibitor.h"

#include <array>
#include <fcntl.h>
#include <mutex>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char **environ;

namespace odo {

namespace {

/// Children that were let go, until the system says that they have ended.
class EndingChildren
{
public:
    void add(pid_t process)
    {
        const std::lock_guard lock(m_mutex);
        m_processes.push_back(process);
        std::erase_if(m_processes, [](pid_t each) { return ::waitpid(each, nullptr, WNOHANG) != 0; });
    }

private:
    std::mutex m_mutex;
    std::vector<pid_t> m_processes;
};

EndingChildren &endingChildren()
{
    static EndingChildren children;
    return children;
}

/// systemd-inhibit keeps its lock as long as the command that it runs, which waits for the end of the pipe.
/// -1: it cannot be started. In a group of its own, so that Ctrl-C in a terminal does not end it before the
/// work has stopped.
pid_t startHolder(const std::string &why, int pipeEnd)
{
    std::string program = "systemd-inhibit", what = "--what=sleep:idle:handle-lid-switch",
                who = "--who=Odograph", mode = "--mode=block", reason = "--why=" + why, command = "cat";
    std::array<char *, 7> arguments{program.data(), what.data(),    who.data(), reason.data(),
                                    mode.data(),    command.data(), nullptr};
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_adddup2(&files, pipeEnd, STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&files, output, "/dev/null", O_WRONLY, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    pid_t process = -1;
    if (::posix_spawnp(&process, program.c_str(), &files, &attributes, arguments.data(), environ) != 0)
        process = -1;
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
    return process;
}

} // namespace

std::unique_ptr<SleepInhibitor> SleepInhibitor::take(const std::string &why)
{
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        return nullptr;
    const pid_t process = startHolder(why, ends[0]);
    ::close(ends[0]);
    if (process < 0) {
        ::close(ends[1]);
        return nullptr;
    }
    return std::unique_ptr<SleepInhibitor>(new SleepInhibitor(process, ends[1]));
}

SleepInhibitor::~SleepInhibitor()
{
    ::close(m_pipe);
    endingChildren().add(m_process);
}

} // namespace odo
