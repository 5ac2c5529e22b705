// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <arv.h>

#include <memory>
#include <string>

namespace odo {

struct GObjectRelease
{
    void operator()(void *object) const { g_object_unref(object); }
};
/// Owns one reference of an object of Aravis.
template <class T>
using ArvPointer = std::unique_ptr<T, GObjectRelease>;

struct GFree
{
    void operator()(void *memory) const { g_free(memory); }
};
/// Owns a list that Aravis has allocated, not what is in it.
template <class T>
using ArvList = std::unique_ptr<T[], GFree>;

/// Takes the error of one call of Aravis: `ArvFailure failure; arv_...(camera, failure.out()); if (failure)
/// ...`.
class ArvFailure
{
public:
    ArvFailure() = default;
    ~ArvFailure() { g_clear_error(&m_error); }
    ArvFailure(const ArvFailure &) = delete;
    ArvFailure &operator=(const ArvFailure &) = delete;

    GError **out()
    {
        g_clear_error(&m_error);
        return &m_error;
    }
    explicit operator bool() const { return m_error != nullptr; }
    bool is(ArvDeviceError code) const { return g_error_matches(m_error, ARV_DEVICE_ERROR, code); }
    std::string words() const { return m_error ? m_error->message : ""; }

private:
    GError *m_error = nullptr;
};

} // namespace odo
