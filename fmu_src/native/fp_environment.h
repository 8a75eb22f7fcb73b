/* How the processor rounds, and whether it flushes small numbers to zero: the host's own is put
   aside while the FMU computes, so that a host compiled with -ffast-math gets the same bits, and
   finds its own again, flags included. */
#ifndef HOLONOM_FP_ENVIRONMENT_H
#define HOLONOM_FP_ENVIRONMENT_H

#include <stdint.h>

typedef uint64_t fp_environment;

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
enum { FP_DEFAULT = 0x1f80 }; /* to nearest, all exceptions masked, subnormal numbers kept */
static inline fp_environment fp_enter(void)
{
    const fp_environment host = _mm_getcsr();
    _mm_setcsr(FP_DEFAULT);
    return host;
}
static inline void fp_leave(fp_environment host) { _mm_setcsr((unsigned)host); }
#elif defined(__aarch64__)
static inline fp_environment fp_enter(void)
{
    fp_environment host;
    __asm__ volatile("mrs %0, fpcr" : "=r"(host));
    __asm__ volatile("msr fpcr, %0"
                     :
                     : "r"((fp_environment)0)); /* to nearest, no traps, subnormal numbers kept */
    return host;
}
static inline void fp_leave(fp_environment host) { __asm__ volatile("msr fpcr, %0" : : "r"(host)); }
#else
/* Of other processors it is taken as it is: targets without an operating system keep defaults. */
static inline fp_environment fp_enter(void) { return 0; }
static inline void fp_leave(fp_environment host) { (void)host; }
#endif

#endif
