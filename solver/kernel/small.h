/* Included first, and again last, by files whose functions run seldom, or wait for others: they are
   compiled for size, but where nothing is optimised, so that counts of lines are true. */
#if defined(__clang__)
#ifndef HM_SMALL
#define HM_SMALL
#pragma clang attribute push(__attribute__((minsize)), apply_to = function)
#else
#undef HM_SMALL
#pragma clang attribute pop
#endif
#elif defined(__GNUC__) && defined(__OPTIMIZE__)
#pragma GCC optimize("Os")
#endif
