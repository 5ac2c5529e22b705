// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/resolved_path.h"

#include "core/base/file_system.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace odo {

namespace {

constexpr int mostLinks = 40; // as the kernel

struct FreeText
{
    void operator()(char *text) const { std::free(text); } // NOLINT: realpath() allocates so
};

} // namespace

std::optional<std::filesystem::path> realPath(const std::filesystem::path &file)
{
    const std::unique_ptr<char, FreeText> real(::realpath(file.c_str(), nullptr));
    return real ? std::optional<std::filesystem::path>(real.get()) : std::nullopt;
}

Result<ResolvedPath> resolved(const std::filesystem::path &file)
{
    const std::string what = "file '" + file.string() + "'";
    if (file.empty())
        return fail(ErrorCode::WrongCall, what, "it has no name", "name a file");
    std::filesystem::path named = files::absolute(file);
    ResolvedPath resolved;
    for (int links = 0; links < mostLinks; ++links) {
        resolved.named.push_back(named.lexically_normal());
        const std::filesystem::path name = named.filename(), folder = named.parent_path();
        if (name.empty() || name == "." || name == "..")
            return fail(ErrorCode::WrongCall, what, "it is a folder", "name a file");
        const auto realFolder = realPath(folder);
        if (!realFolder && errno == ENOENT)
            return fail(ErrorCode::NotFound, what, "there is no folder '" + folder.string() + "'",
                        "make the folder first, or choose another one");
        if (!realFolder)
            return fail(ErrorCode::Io, what, std::string("its folder cannot be used (") + std::strerror(errno) + ")",
                        "choose another folder");
        resolved.real = *realFolder / name;
        std::error_code isNoLink;
        const std::filesystem::path link = files::linkTarget(resolved.real, isNoLink);
        if (isNoLink)
            return resolved;
        named = *realFolder / link; // an absolute one replaces the folder
    }
    return fail(ErrorCode::Io, what, std::string("it cannot be written (") + std::strerror(ELOOP) + ")", "choose another name");
}

} // namespace odo
