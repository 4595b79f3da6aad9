/*
 * twins.h - where a package can give no options to the compiler, core/march.h and
 * core/preweighted.h include this file first (toolchain/dist): it names the marches and passages
 * that a Cortex-M, or a RISC-V of 32 bits with multiplication, has of its own.
 */
#ifndef TWINS_H
#define TWINS_H

#if defined(__ARM_ARCH_PROFILE) && __ARM_ARCH_PROFILE == 'M'

#ifndef QV_MARCH_HEADER
#ifdef __ARM_FEATURE_MVE
#define QV_MARCH_HEADER "helium.h"
#else
#define QV_MARCH_HEADER "march_walk.h"
#endif
#endif

#ifndef QV_PASSAGE_HEADER
#ifdef __thumb2__
#define QV_PASSAGE_HEADER "passage_v7m.h"
#else
#define QV_PASSAGE_HEADER "passage_v6m.h"
#endif
#endif

#elif defined(__riscv_mul) && __riscv_xlen == 32 && !defined(__riscv_32e)

#ifndef QV_MARCH_HEADER
#define QV_MARCH_HEADER "march_walk.h"
#endif

#endif

#endif /* TWINS_H */
