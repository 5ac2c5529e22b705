// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>

namespace odo {

/// Where the school's hub is: postgresql://user@host:port/database?sslmode=verify-full, as psql takes it.
/// What is left out is what libpq takes instead: this computer's socket, the login's own name, port 5432.
/// Plain value.
struct HubAddress
{
    std::string user, host, database;
    int port = 0;            ///< 0: not given
    std::string sslMode;     ///< "prefer" where none is given
    std::string sslRootCert; ///< a file; empty: libpq's own
    /// What a person entered, for as long as this value lives; empty: what ~/.pgpass or PGPASSWORD has. No
    /// URL and no error has it.
    std::string password = {};

    /// InvalidInput for what is no such URL, names no database, has an option that is not known, or holds a
    /// password: that belongs in ~/.pgpass or PGPASSWORD. No error repeats the password.
    static Result<HubAddress> parse(const std::string &url);
    /// As a URL again, the same for the same hub.
    std::string url() const;
    /// "school hub 'db.school.example/robots'".
    Message subject() const;
};

/// That the server takes no login without a password, or not with the one that it got.
tl::unexpected<Error> needsPassword(Message subject, bool gotOne);
/// Whether that is what an error says.
bool isPasswordNeeded(const Error &error);

} // namespace odo
