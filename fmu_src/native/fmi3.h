/* FMI 3.0 for co-simulation (sections 2.2 and 4): the functions that this FMU has, and the names of
   those that it refuses. */
#ifndef HOLONOM_FMI3_H
#define HOLONOM_FMI3_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef void *fmi3_instance, *fmi3_saved; /* fmi3Instance, fmi3FMUState */
typedef uint32_t fmi3_reference;
typedef bool fmi3_boolean;
typedef const char *fmi3_text;
typedef uint8_t fmi3_byte;
typedef enum { FMI3_OK, FMI3_WARNING, FMI3_DISCARD, FMI3_ERROR, FMI3_FATAL } fmi3_status;
typedef void (*fmi3_logger)(void *environment, fmi3_status status, fmi3_text category,
                            fmi3_text message);
typedef void (*fmi3_callback)(void); /* of other kinds, which this FMU never calls */

#define FMI3_VALUES(X, type, name)                                                                 \
    X(fmi3_status, fmi3Get##name, (fmi3_instance, const fmi3_reference[], size_t, type[], size_t)) \
    X(fmi3_status, fmi3Set##name,                                                                  \
      (fmi3_instance, const fmi3_reference[], size_t, const type[], size_t))

/* X(result, name, arguments) for each function. */
#define FMI3_FUNCTIONS(X)                                                                          \
    X(fmi3_text, fmi3GetVersion, (void))                                                           \
    X(fmi3_status, fmi3SetDebugLogging, (fmi3_instance, fmi3_boolean, size_t, const fmi3_text[]))  \
    X(fmi3_instance, fmi3InstantiateCoSimulation,                                                  \
      (fmi3_text, fmi3_text, fmi3_text, fmi3_boolean, fmi3_boolean, fmi3_boolean, fmi3_boolean,    \
       const fmi3_reference[], size_t, void *, fmi3_logger, fmi3_callback))                        \
    X(fmi3_instance, fmi3InstantiateModelExchange,                                                 \
      (fmi3_text, fmi3_text, fmi3_text, fmi3_boolean, fmi3_boolean, void *, fmi3_logger))          \
    X(fmi3_instance, fmi3InstantiateScheduledExecution,                                            \
      (fmi3_text, fmi3_text, fmi3_text, fmi3_boolean, fmi3_boolean, void *, fmi3_logger,           \
       fmi3_callback, fmi3_callback, fmi3_callback))                                               \
    X(void, fmi3FreeInstance, (fmi3_instance))                                                     \
    X(fmi3_status, fmi3EnterInitializationMode,                                                    \
      (fmi3_instance, fmi3_boolean, double, double, fmi3_boolean, double))                         \
    X(fmi3_status, fmi3ExitInitializationMode, (fmi3_instance))                                    \
    X(fmi3_status, fmi3Terminate, (fmi3_instance))                                                 \
    X(fmi3_status, fmi3Reset, (fmi3_instance))                                                     \
    FMI3_VALUES(X, double, Float64)                                                                \
    FMI3_VALUES(X, fmi3_boolean, Boolean)                                                          \
    FMI3_VALUES(X, fmi3_text, String)                                                              \
    X(fmi3_status, fmi3GetOutputDerivatives,                                                       \
      (fmi3_instance, const fmi3_reference[], size_t, const int32_t[], double[], size_t))          \
    X(fmi3_status, fmi3GetFMUState, (fmi3_instance, fmi3_saved *))                                 \
    X(fmi3_status, fmi3SetFMUState, (fmi3_instance, fmi3_saved))                                   \
    X(fmi3_status, fmi3FreeFMUState, (fmi3_instance, fmi3_saved *))                                \
    X(fmi3_status, fmi3SerializedFMUStateSize, (fmi3_instance, fmi3_saved, size_t *))              \
    X(fmi3_status, fmi3SerializeFMUState, (fmi3_instance, fmi3_saved, fmi3_byte[], size_t))        \
    X(fmi3_status, fmi3DeserializeFMUState,                                                        \
      (fmi3_instance, const fmi3_byte[], size_t, fmi3_saved *))                                    \
    X(fmi3_status, fmi3DoStep,                                                                     \
      (fmi3_instance, double, double, fmi3_boolean, fmi3_boolean *, fmi3_boolean *,                \
       fmi3_boolean *, double *))

/* X(name) for each getter and setter of a type that no variable has; none at all is fine. */
#define FMI3_OTHER_TYPES(X)                                                                        \
    X(fmi3GetFloat32) X(fmi3GetInt8) X(fmi3GetUInt8) X(fmi3GetInt16) X(fmi3GetUInt16)              \
    X(fmi3GetInt32) X(fmi3GetUInt32) X(fmi3GetInt64) X(fmi3GetUInt64) X(fmi3GetBinary)             \
    X(fmi3GetClock) X(fmi3SetFloat32) X(fmi3SetInt8) X(fmi3SetUInt8) X(fmi3SetInt16)               \
    X(fmi3SetUInt16) X(fmi3SetInt32) X(fmi3SetUInt32) X(fmi3SetInt64) X(fmi3SetUInt64)             \
    X(fmi3SetBinary) X(fmi3SetClock)

/* X(name) for each function of events, clocks, model exchange, configuration and derivatives. */
#define FMI3_REFUSED(X)                                                                            \
    X(fmi3EnterEventMode) X(fmi3EnterStepMode) X(fmi3EvaluateDiscreteStates)                       \
    X(fmi3UpdateDiscreteStates) X(fmi3EnterConfigurationMode) X(fmi3ExitConfigurationMode)         \
    X(fmi3GetNumberOfVariableDependencies) X(fmi3GetVariableDependencies)                          \
    X(fmi3GetDirectionalDerivative) X(fmi3GetAdjointDerivative) X(fmi3GetIntervalDecimal)          \
    X(fmi3GetIntervalFraction) X(fmi3GetShiftDecimal) X(fmi3GetShiftFraction)                      \
    X(fmi3SetIntervalDecimal) X(fmi3SetIntervalFraction) X(fmi3SetShiftDecimal)                    \
    X(fmi3SetShiftFraction) X(fmi3EnterContinuousTimeMode) X(fmi3CompletedIntegratorStep)          \
    X(fmi3SetTime) X(fmi3SetContinuousStates) X(fmi3GetContinuousStateDerivatives)                 \
    X(fmi3GetEventIndicators) X(fmi3GetContinuousStates) X(fmi3GetNominalsOfContinuousStates)      \
    X(fmi3GetNumberOfEventIndicators) X(fmi3GetNumberOfContinuousStates)                           \
    X(fmi3ActivateModelPartition)

#endif
