// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Before the definition of a function of plain loops over whole numbers: it is compiled for vectors of 32
/// bytes besides, with all that it calls, and the program takes that version where the processor has them.
/// The results are the same. Sanitizers are not ready yet when the choice is made; of compilers only GCC
/// makes it for member functions with lambdas.
#if defined(__x86_64__) && defined(__linux__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&    \
    !defined(__SANITIZE_THREAD__)
#define ODO_WIDE_VECTORS __attribute__((flatten, target_clones("avx2", "default")))
#else
#define ODO_WIDE_VECTORS
#endif
