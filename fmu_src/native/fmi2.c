/* The functions of FMI 2.0 for co-simulation. */
#include "small.h"

#include "exported.h"
#include "fmi2.h"
#include "slave.h"

#include <string.h>

#define DECLARE(result, name, arguments) EXPORTED result name arguments;
FMI2_FUNCTIONS(DECLARE)

static fmi2_status status_of(slave_answer answer) { return (fmi2_status)answer; }

static fmi2_status refuse(fmi2_component c, const char *why)
{ return c ? status_of(slave_tell(c, ANSWER_ERROR, "%s", why)) : FMI2_ERROR; }

/* A function that hands its arguments on to the slave, if there is one. */
#define CALL(name, arguments, answer) \
    fmi2_status name arguments { return c ? status_of(answer) : FMI2_ERROR; }

static void say_line(const slave *s, slave_answer level, const char *sentence)
{
    const fmi2_callbacks *callbacks = s->log.logger;
    callbacks->logger(s->log.environment, s->name, status_of(level), slave_categories[level],
                      sentence);
}

const char *fmi2GetTypesPlatform(void) { return "default"; }
const char *fmi2GetVersion(void) { return "2.0"; }

CALL(fmi2SetDebugLogging,
     (fmi2_component c, fmi2_boolean on, size_t count, const fmi2_text category[]),
     slave_switch_log(c, on, count, category))

fmi2_component fmi2Instantiate(fmi2_text name, fmi2_type type, fmi2_text guid, fmi2_text resources,
                               const fmi2_callbacks *callbacks, fmi2_boolean is_visible,
                               fmi2_boolean is_logging)
{
    (void)is_visible;
    const int hears = callbacks && callbacks->logger;
    const slave_log log = {
        .logger = hears ? (void *)(uintptr_t)callbacks : NULL,
        .environment = hears ? callbacks->environment : NULL,
        .say_line = say_line,
        .wanted = is_logging ? DEBUGGING : QUIET,
        .is_format = 1,
    };
    if (type == FMI2_CO_SIMULATION) return slave_make(name, guid, resources, 2, log);
    if (hears)
        callbacks->logger(callbacks->environment, name ? name : "", FMI2_ERROR,
                          slave_categories[ANSWER_ERROR],
                          "instantiate: this FMU is for co-simulation, not for model exchange");
    return NULL;
}

void fmi2FreeInstance(fmi2_component c) { slave_free(c); }

CALL(fmi2SetupExperiment,
     (fmi2_component c, fmi2_boolean has_tolerance, double tolerance, double start,
      fmi2_boolean has_stop, double stop),
     slave_set_up(c, start, has_stop ? &stop : NULL, has_tolerance ? &tolerance : NULL))

CALL(fmi2EnterInitializationMode, (fmi2_component c), slave_begin_initialization(c))
CALL(fmi2ExitInitializationMode, (fmi2_component c), slave_end_initialization(c))
CALL(fmi2Terminate, (fmi2_component c), slave_terminate(c))
CALL(fmi2Reset, (fmi2_component c), slave_reset(c))

/* --------------------------------------------------------------------------------------- values */

CALL(fmi2GetReal, (fmi2_component c, const fmi2_reference index[], size_t count, double value[]),
     slave_get(c, TYPE_REAL, index, count, value))
CALL(fmi2SetReal,
     (fmi2_component c, const fmi2_reference index[], size_t count, const double value[]),
     slave_set(c, TYPE_REAL, index, count, value, NULL))

fmi2_status fmi2GetInteger(fmi2_component c, const fmi2_reference index[], size_t count,
                           int value[])
{
    (void)index, (void)value;
    return c && !count ? FMI2_OK : refuse(c, "there are no Integer variables");
}

fmi2_status fmi2SetInteger(fmi2_component c, const fmi2_reference index[], size_t count,
                           const int value[])
{
    return fmi2GetInteger(c, index, count, (int *)(uintptr_t)value);
}

fmi2_status fmi2GetBoolean(fmi2_component c, const fmi2_reference index[], size_t count,
                           fmi2_boolean value[])
{
    slave_answer answer = ANSWER_OK;
    if (!c) return FMI2_ERROR;
    if (count && !(index && value))
        return refuse(c, "value references or the place for values are missing");
    for (size_t k = 0; k < count && !answer; k++) answer = slave_get_truth(c, index[k], value + k);
    return status_of(answer);
}

fmi2_status fmi2SetBoolean(fmi2_component c, const fmi2_reference index[], size_t count,
                           const fmi2_boolean value[])
{
    double truth[MOST_WORDS];
    for (size_t k = 0; value && k < count && k < MOST_WORDS; k++) truth[k] = value[k] != 0;
    return c ? status_of(slave_set_truths(c, index, count, value ? truth : NULL)) : FMI2_ERROR;
}

CALL(fmi2GetString,
     (fmi2_component c, const fmi2_reference index[], size_t count, fmi2_text value[]),
     slave_get_words(c, index, count, value))
CALL(fmi2SetString,
     (fmi2_component c, const fmi2_reference index[], size_t count, const fmi2_text value[]),
     slave_set_words(c, index, count, value))

/* --------------------------------------------------------------------------------------- states */

CALL(fmi2GetFMUstate, (fmi2_component c, fmi2_saved *state), slave_keep(c, (slave_kept **)state))
CALL(fmi2SetFMUstate, (fmi2_component c, fmi2_saved state), slave_return_to(c, state))
CALL(fmi2FreeFMUstate, (fmi2_component c, fmi2_saved *state), slave_free_kept((slave_kept **)state))
CALL(fmi2SerializedFMUstateSize, (fmi2_component c, fmi2_saved state, size_t *size),
     slave_size_of_bytes(c, state, size))
CALL(fmi2SerializeFMUstate, (fmi2_component c, fmi2_saved state, fmi2_byte bytes[], size_t size),
     slave_bytes_of(c, state, bytes, size))
CALL(fmi2DeSerializeFMUstate,
     (fmi2_component c, const fmi2_byte bytes[], size_t size, fmi2_saved *state),
     slave_kept_of(c, bytes, size, (slave_kept **)state))

/* ---------------------------------------------------------------------------------------- steps */

fmi2_status fmi2DoStep(fmi2_component c, double t, double step, fmi2_boolean is_never_repeated)
{
    (void)is_never_repeated;
    return c ? status_of(slave_step(c, t, step)) : FMI2_ERROR;
}

fmi2_status fmi2CancelStep(fmi2_component c)
{ return refuse(c, "no step runs on its own, none can be cancelled"); }

fmi2_status fmi2GetDirectionalDerivative(fmi2_component c, const fmi2_reference unknown[],
                                         size_t n_unknown, const fmi2_reference known[],
                                         size_t n_known, const double change[], double derivative[])
{
    (void)unknown, (void)n_unknown, (void)known, (void)n_known, (void)change, (void)derivative;
    return refuse(c, "this FMU gives no directional derivatives");
}

fmi2_status fmi2SetRealInputDerivatives(fmi2_component c, const fmi2_reference index[],
                                        size_t count, const int order[], const double value[])
{
    (void)index, (void)count, (void)order, (void)value;
    return refuse(c, "this FMU takes no derivatives of inputs; interpolation = \"ramp\" or "
                     "\"smooth\" in [inputs] moves them");
}

CALL(fmi2GetRealOutputDerivatives,
     (fmi2_component c, const fmi2_reference index[], size_t count, const int order[],
      double value[]),
     slave_get_derivatives(c, index, count, order, value))

fmi2_status fmi2GetRealStatus(fmi2_component c, fmi2_status_kind kind, double *value)
{
    if (!c || !value) return refuse(c, "there is no place for the status");
    if (kind != FMI2_LAST_SUCCESSFUL_TIME) return FMI2_DISCARD;
    *value = slave_last_time(c);
    return FMI2_OK;
}

fmi2_status fmi2GetBooleanStatus(fmi2_component c, fmi2_status_kind kind, fmi2_boolean *value)
{
    if (!c || !value) return refuse(c, "there is no place for the status");
    if (kind != FMI2_TERMINATED) return FMI2_DISCARD;
    *value = 0;
    return FMI2_OK;
}

/* Of steps that run on their own, of which there are none. */
fmi2_status fmi2GetStatus(fmi2_component c, fmi2_status_kind kind, fmi2_status *value)
{ return (void)kind, (void)value, c ? FMI2_DISCARD : FMI2_ERROR; }
fmi2_status fmi2GetIntegerStatus(fmi2_component c, fmi2_status_kind kind, int *value)
{ return (void)kind, (void)value, c ? FMI2_DISCARD : FMI2_ERROR; }
fmi2_status fmi2GetStringStatus(fmi2_component c, fmi2_status_kind kind, fmi2_text *value)
{ return (void)kind, (void)value, c ? FMI2_DISCARD : FMI2_ERROR; }

#include "small.h"
