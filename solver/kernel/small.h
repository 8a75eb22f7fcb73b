/* Included first by files whose functions run seldom, or wait for others: they are compiled for size. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("Os")
#endif
