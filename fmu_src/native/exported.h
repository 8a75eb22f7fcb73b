/* How a function of the standard is made visible. In sources that an importer compiles into a static program each has the prefix
   that the importer or build_fmu/source_package.py defines. */
#ifndef HOLONOM_EXPORTED_H
#define HOLONOM_EXPORTED_H

#if defined(HOLONOM_SOURCE)
#define EXPORTED
#elif defined(_WIN32)
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED __attribute__((visibility("default")))
#endif

#endif
