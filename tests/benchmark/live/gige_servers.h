// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QStringList>

#include <cstdint>

namespace odo::test {

/// Addresses of the two cameras.
constexpr const char *gigeAddresses[] = {"127.31.200.2", "127.31.200.3"};

/// Two GigE cameras in this process until standard input ends: the child's part. Prints "ready" once they
/// answer, does what each line says ("skip 0": the first camera takes a picture that it never sends), and
/// prints at its end how many pictures each has sent and what processor time that took. The exit status.
int serveGigeCameras(int widthPx, double framesPerSecond);

/// Two GigE cameras in a process of their own, so that what they cost is not ours.
class GigeServers
{
public:
    GigeServers(int widthPx, double framesPerSecond);
    ~GigeServers();
    GigeServers(const GigeServers &) = delete;
    GigeServers &operator=(const GigeServers &) = delete;

    bool isReady() const { return m_ready; }
    /// The camera loses one picture on the wire.
    void skip(std::size_t camera);
    std::uint64_t skipped(std::size_t camera) const { return m_skipped[camera]; }

private:
    QProcess m_process;
    bool m_ready = false;
    std::uint64_t m_skipped[2] = {0, 0};
};

} // namespace odo::test
