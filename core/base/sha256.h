// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>

struct evp_md_ctx_st;

namespace odo {

/// SHA-256 (FIPS 180-4) by OpenSSL, which uses the processor's own instructions where it has them: files are
/// then hashed as fast as a disk gives them, which Qt's and libav's do not reach. One object on one thread at
/// a time.
class Sha256
{
public:
    Sha256();
    void add(const void *bytes, std::size_t count);
    /// Of all that was added, in lower-case hexadecimal; nothing can be added afterwards.
    std::string hex();

private:
    struct Free
    {
        void operator()(evp_md_ctx_st *context) const;
    };
    std::unique_ptr<evp_md_ctx_st, Free> m_context;
};

} // namespace odo
