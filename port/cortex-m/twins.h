/*
 * twins.h - where a package can give no options to the compiler, core/march.h includes this file
 * first (toolchain/dist): it names the marches that this Cortex-M has of its own, if any.
 */
#ifndef TWINS_H
#define TWINS_H

#if !defined(QV_MARCH_HEADER) && defined(__ARM_ARCH_PROFILE)
#if __ARM_ARCH_PROFILE == 'M' && defined(__ARM_FEATURE_MVE)
#define QV_MARCH_HEADER "helium.h"
#elif __ARM_ARCH_PROFILE == 'M'
#define QV_MARCH_HEADER "thumb.h"
#endif
#endif

#endif /* TWINS_H */
