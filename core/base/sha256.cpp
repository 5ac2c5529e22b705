// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"

#include <array>
#include <new>
#include <openssl/evp.h>

namespace odo {

namespace {

/// Here OpenSSL can only fail for lack of memory.
void orThrow(int done)
{
    if (done != 1)
        throw std::bad_alloc();
}

} // namespace

void Sha256::Free::operator()(evp_md_ctx_st *context) const
{
    EVP_MD_CTX_free(context);
}

Sha256::Sha256() : m_context(EVP_MD_CTX_new())
{
    orThrow(m_context ? EVP_DigestInit_ex(m_context.get(), EVP_sha256(), nullptr) : 0);
}

void Sha256::add(const void *bytes, std::size_t count)
{
    orThrow(EVP_DigestUpdate(m_context.get(), bytes, count));
}

std::string Sha256::hex()
{
    constexpr const char *digits = "0123456789abcdef";
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned size = 0;
    orThrow(EVP_DigestFinal_ex(m_context.get(), digest.data(), &size));
    std::string text;
    for (unsigned i = 0; i < size; ++i) {
        text += digits[digest[i] >> 4];
        text += digits[digest[i] & 15];
    }
    return text;
}

} // namespace odo
