/* Products and sums are rounded one by one, on all machines alike: a fused operation gives another
   number. */
#ifndef HOLONOM_ROUNDING_H
#define HOLONOM_ROUNDING_H

#ifdef __FAST_MATH__
#error "the core needs IEEE arithmetic: compile it without -ffast-math"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize(                                                                              \
    "fp-contract=off") /* in its gnu modes GCC fuses whatever the standard's pragma says */
#endif

#endif
