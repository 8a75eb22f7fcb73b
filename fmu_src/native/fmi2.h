/* FMI 2.0.5 for co-simulation (sections 2.1 and 4.2): what an importer and an FMU say to each
   other. */
#ifndef HOLONOM_FMI2_H
#define HOLONOM_FMI2_H

#include <stddef.h>

typedef void *fmi2_component, *fmi2_saved; /* an instance; fmi2FMUstate */
typedef unsigned int fmi2_reference;
typedef int fmi2_boolean;
typedef const char *fmi2_text;
typedef unsigned char fmi2_byte;

typedef enum {
    FMI2_OK,
    FMI2_WARNING,
    FMI2_DISCARD,
    FMI2_ERROR,
    FMI2_FATAL,
    FMI2_PENDING
} fmi2_status;
typedef enum {
    FMI2_DO_STEP_STATUS,
    FMI2_PENDING_STATUS,
    FMI2_LAST_SUCCESSFUL_TIME,
    FMI2_TERMINATED
} fmi2_status_kind;
typedef enum { FMI2_MODEL_EXCHANGE, FMI2_CO_SIMULATION } fmi2_type;

typedef struct fmi2_callbacks {
    void (*logger)(void *environment, fmi2_text instance, fmi2_status status, fmi2_text category,
                   fmi2_text message, ...);
    void *(*allocate)(size_t count, size_t size);
    void (*release)(void *memory);
    void (*step_finished)(void *environment, fmi2_status status);
    void *environment;
} fmi2_callbacks;

#define FMI2_VALUES(X, type, name) \
    X(fmi2_status, fmi2Get##name, (fmi2_component, const fmi2_reference[], size_t, type[])) \
    X(fmi2_status, fmi2Set##name, (fmi2_component, const fmi2_reference[], size_t, const type[]))

/* X(result, name, arguments) for each function. */
#define FMI2_FUNCTIONS(X)                                                                          \
    X(fmi2_text, fmi2GetTypesPlatform, (void))                                                     \
    X(fmi2_text, fmi2GetVersion, (void))                                                           \
    X(fmi2_status, fmi2SetDebugLogging, (fmi2_component, fmi2_boolean, size_t, const fmi2_text[])) \
    X(fmi2_component, fmi2Instantiate,                                                             \
      (fmi2_text, fmi2_type, fmi2_text, fmi2_text, const fmi2_callbacks *, fmi2_boolean,           \
       fmi2_boolean))                                                                              \
    X(void, fmi2FreeInstance, (fmi2_component))                                                    \
    X(fmi2_status, fmi2SetupExperiment,                                                            \
      (fmi2_component, fmi2_boolean, double, double, fmi2_boolean, double))                        \
    X(fmi2_status, fmi2EnterInitializationMode, (fmi2_component))                                  \
    X(fmi2_status, fmi2ExitInitializationMode, (fmi2_component))                                   \
    X(fmi2_status, fmi2Terminate, (fmi2_component))                                                \
    X(fmi2_status, fmi2Reset, (fmi2_component))                                                    \
    FMI2_VALUES(X, double, Real)                                                                   \
    FMI2_VALUES(X, int, Integer)                                                                   \
    FMI2_VALUES(X, fmi2_boolean, Boolean)                                                          \
    FMI2_VALUES(X, fmi2_text, String)                                                              \
    X(fmi2_status, fmi2GetFMUstate, (fmi2_component, fmi2_saved *))                                \
    X(fmi2_status, fmi2SetFMUstate, (fmi2_component, fmi2_saved))                                  \
    X(fmi2_status, fmi2FreeFMUstate, (fmi2_component, fmi2_saved *))                               \
    X(fmi2_status, fmi2SerializedFMUstateSize, (fmi2_component, fmi2_saved, size_t *))             \
    X(fmi2_status, fmi2SerializeFMUstate, (fmi2_component, fmi2_saved, fmi2_byte[], size_t))       \
    X(fmi2_status, fmi2DeSerializeFMUstate,                                                        \
      (fmi2_component, const fmi2_byte[], size_t, fmi2_saved *))                                   \
    X(fmi2_status, fmi2GetDirectionalDerivative,                                                   \
      (fmi2_component, const fmi2_reference[], size_t, const fmi2_reference[], size_t,             \
       const double[], double[]))                                                                  \
    X(fmi2_status, fmi2SetRealInputDerivatives,                                                    \
      (fmi2_component, const fmi2_reference[], size_t, const int[], const double[]))               \
    X(fmi2_status, fmi2GetRealOutputDerivatives,                                                   \
      (fmi2_component, const fmi2_reference[], size_t, const int[], double[]))                     \
    X(fmi2_status, fmi2DoStep, (fmi2_component, double, double, fmi2_boolean))                     \
    X(fmi2_status, fmi2CancelStep, (fmi2_component))                                               \
    X(fmi2_status, fmi2GetStatus, (fmi2_component, fmi2_status_kind, fmi2_status *))               \
    X(fmi2_status, fmi2GetRealStatus, (fmi2_component, fmi2_status_kind, double *))                \
    X(fmi2_status, fmi2GetIntegerStatus, (fmi2_component, fmi2_status_kind, int *))                \
    X(fmi2_status, fmi2GetBooleanStatus, (fmi2_component, fmi2_status_kind, fmi2_boolean *))       \
    X(fmi2_status, fmi2GetStringStatus, (fmi2_component, fmi2_status_kind, fmi2_text *))

#endif
