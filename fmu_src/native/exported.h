/* How a function of the standard is made visible. */
#ifndef HOLONOM_EXPORTED_H
#define HOLONOM_EXPORTED_H

#if defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#elif defined(__GNUC__)
#define EXPORTED __attribute__((visibility("default")))
#else
#define EXPORTED
#endif

#endif
