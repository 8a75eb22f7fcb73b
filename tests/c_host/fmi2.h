/* The functions of FMI 2.0.5 for co-simulation (standard, sections 2.1 and 4.2), as a table:
   FMI2_FUNCTIONS(X) calls X(result, name, arguments) for each.                                     */
#ifndef FMI2_H
#define FMI2_H

#include <stddef.h>

typedef void *component;
typedef unsigned int reference;
typedef int boolean;                /* fmi2Boolean */
typedef const char *text;
typedef void *saved;                /* fmi2FMUstate */
typedef unsigned char byte;

enum status { OK, WARNING, DISCARD, ERROR, FATAL, PENDING };
enum status_kind { DO_STEP_STATUS, PENDING_STATUS, LAST_SUCCESSFUL_TIME, TERMINATED };
enum { CO_SIMULATION = 1 };

struct callbacks {
    void (*logger)(void *environment, text instance, int status, text category, text message, ...);
    void *(*allocate)(size_t count, size_t size);
    void (*release)(void *memory);
    void (*step_finished)(void *environment, int status);
    void *environment;
};

#define FMI2_VALUES(X, type, name) \
    X(int, fmi2Get##name, (component, const reference[], size_t, type[])) \
    X(int, fmi2Set##name, (component, const reference[], size_t, const type[]))

#define FMI2_FUNCTIONS(X) \
    X(text, fmi2GetTypesPlatform, (void)) \
    X(text, fmi2GetVersion, (void)) \
    X(int, fmi2SetDebugLogging, (component, boolean, size_t, const text[])) \
    X(component, fmi2Instantiate, \
      (text, int, text, text, const struct callbacks *, boolean, boolean)) \
    X(void, fmi2FreeInstance, (component)) \
    X(int, fmi2SetupExperiment, (component, boolean, double, double, boolean, double)) \
    X(int, fmi2EnterInitializationMode, (component)) \
    X(int, fmi2ExitInitializationMode, (component)) \
    X(int, fmi2Terminate, (component)) \
    X(int, fmi2Reset, (component)) \
    FMI2_VALUES(X, double, Real) \
    FMI2_VALUES(X, int, Integer) \
    FMI2_VALUES(X, boolean, Boolean) \
    FMI2_VALUES(X, text, String) \
    X(int, fmi2GetFMUstate, (component, saved *)) \
    X(int, fmi2SetFMUstate, (component, saved)) \
    X(int, fmi2FreeFMUstate, (component, saved *)) \
    X(int, fmi2SerializedFMUstateSize, (component, saved, size_t *)) \
    X(int, fmi2SerializeFMUstate, (component, saved, byte[], size_t)) \
    X(int, fmi2DeSerializeFMUstate, (component, const byte[], size_t, saved *)) \
    X(int, fmi2GetDirectionalDerivative, (component, const reference[], size_t, \
      const reference[], size_t, const double[], double[])) \
    X(int, fmi2SetRealInputDerivatives, \
      (component, const reference[], size_t, const int[], const double[])) \
    X(int, fmi2GetRealOutputDerivatives, \
      (component, const reference[], size_t, const int[], double[])) \
    X(int, fmi2DoStep, (component, double, double, boolean)) \
    X(int, fmi2CancelStep, (component)) \
    X(int, fmi2GetStatus, (component, int, int *)) \
    X(int, fmi2GetRealStatus, (component, int, double *)) \
    X(int, fmi2GetIntegerStatus, (component, int, int *)) \
    X(int, fmi2GetBooleanStatus, (component, int, boolean *)) \
    X(int, fmi2GetStringStatus, (component, int, text *))

/* An FMU's library, and where its functions are. */
struct fmu {
    void *library;
    text resources;                 /* URI of the folder */
    char guid[64];
#define FMI2_POINTER(result, name, arguments) result (*name) arguments;
    FMI2_FUNCTIONS(FMI2_POINTER)
#undef FMI2_POINTER
};

#endif
