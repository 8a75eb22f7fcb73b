/* The functions of FMI 3.0 for co-simulation. */
#include "small.h"

#include "exported.h"
#include "fmi3.h"
#include "slave.h"

#include <string.h>

#define DECLARE(result, name, arguments) EXPORTED result name arguments;
FMI3_FUNCTIONS(DECLARE)

static fmi3_status status_of(slave_answer answer) { return (fmi3_status)answer; }

static fmi3_status refuse(fmi3_instance c, const char *why)
{ return c ? status_of(slave_tell(c, ANSWER_ERROR, "%s", why)) : FMI3_ERROR; }

/* A function that hands its arguments on to the slave, if there is one. */
#define CALL(name, arguments, answer) \
    fmi3_status name arguments { return c ? status_of(answer) : FMI3_ERROR; }

static void log_line(fmi3_logger logger, void *environment, slave_answer level,
                     const char *sentence)
{
    logger(environment, status_of(level), slave_categories[level], sentence);
}

/* A function's address in the memory of an object pointer, which C has no conversion for. */
typedef union either {
    fmi3_logger function;
    void *address;
} either;

static void say_line(const slave *s, slave_answer level, const char *sentence)
{
    log_line((either){.address = s->log.logger}.function, s->log.environment, level, sentence);
}

const char *fmi3GetVersion(void) { return "3.0"; }

CALL(fmi3SetDebugLogging,
     (fmi3_instance c, fmi3_boolean on, size_t count, const fmi3_text category[]),
     slave_switch_log(c, on, count, category))

static fmi3_instance none(fmi3_logger logger, void *environment, fmi3_boolean is_logging,
                          const char *why)
{
    if (logger && is_logging) log_line(logger, environment, ANSWER_ERROR, why);
    return NULL;
}

fmi3_instance fmi3InstantiateCoSimulation(fmi3_text name, fmi3_text token, fmi3_text resources,
                                          fmi3_boolean is_visible, fmi3_boolean is_logging,
                                          fmi3_boolean uses_events, fmi3_boolean returns_early,
                                          const fmi3_reference intermediate[],
                                          size_t n_intermediate, void *environment,
                                          fmi3_logger logger, fmi3_callback update)
{
    (void)is_visible, (void)returns_early, (void)intermediate, (void)update;
    if (uses_events)
        return none(logger, environment, is_logging, "instantiate: this FMU has no event mode");
    if (n_intermediate)
        return none(logger, environment, is_logging,
                    "instantiate: this FMU gives no values within a communication step");
    const slave_log log = {
        .logger = logger ? (either){.function = logger}.address : NULL,
        .environment = environment,
        .say_line = say_line,
        .wanted = is_logging ? DEBUGGING : 0,
    };
    return slave_make(name, token, resources, 3, log);
}

fmi3_instance fmi3InstantiateModelExchange(fmi3_text name, fmi3_text token, fmi3_text resources,
                                           fmi3_boolean is_visible, fmi3_boolean is_logging,
                                           void *environment, fmi3_logger logger)
{
    (void)name, (void)token, (void)resources, (void)is_visible;
    return none(logger, environment, is_logging,
                "instantiate: this FMU is for co-simulation, not for model exchange");
}

fmi3_instance fmi3InstantiateScheduledExecution(fmi3_text name, fmi3_text token,
                                                fmi3_text resources, fmi3_boolean is_visible,
                                                fmi3_boolean is_logging, void *environment,
                                                fmi3_logger logger, fmi3_callback clock,
                                                fmi3_callback lock, fmi3_callback unlock)
{
    (void)name, (void)token, (void)resources, (void)is_visible, (void)clock, (void)lock,
        (void)unlock;
    return none(logger, environment, is_logging,
                "instantiate: this FMU is for co-simulation, not for scheduled execution");
}

void fmi3FreeInstance(fmi3_instance c) { slave_free(c); }

fmi3_status fmi3EnterInitializationMode(fmi3_instance c, fmi3_boolean has_tolerance,
                                        double tolerance, double start, fmi3_boolean has_stop,
                                        double stop)
{
    if (!c) return FMI3_ERROR;
    const slave_answer answer =
        slave_set_up(c, start, has_stop ? &stop : NULL, has_tolerance ? &tolerance : NULL);
    return status_of(answer ? answer : slave_begin_initialization(c));
}

CALL(fmi3ExitInitializationMode, (fmi3_instance c), slave_end_initialization(c))
CALL(fmi3Terminate, (fmi3_instance c), slave_terminate(c))
CALL(fmi3Reset, (fmi3_instance c), slave_reset(c))

fmi3_status fmi3DoStep(fmi3_instance c, double t, double step, fmi3_boolean is_never_repeated,
                       fmi3_boolean *needs_event, fmi3_boolean *terminates,
                       fmi3_boolean *returned_early, double *last_time)
{
    (void)is_never_repeated;
    if (!c) return FMI3_ERROR;
    if (!(needs_event && terminates && returned_early && last_time))
        return refuse(c, "doStep: there is no place for its results");
    const slave_answer answer = slave_step(c, t, step);
    *needs_event = *terminates = *returned_early = 0;
    *last_time = slave_last_time(c);
    return status_of(answer);
}

/* --------------------------------------------------------------------------------------- values */

static fmi3_status check_counts(fmi3_instance c, size_t count, size_t n_values)
{
    if (c && count == n_values) return FMI3_OK;
    return refuse(
        c, "as many values as value references are needed: no variable of this FMU is an array");
}

/* Likewise, with as many values as value references. */
#define CALL_FOR_VALUES(name, arguments, answer) \
    fmi3_status name arguments \
    { \
        const fmi3_status wrong = check_counts(c, count, n_values); \
        return wrong ? wrong : status_of(answer); \
    }

/* Those of the model count from 1, since OMSimulator takes the references of dependencies for
   places in the list. */
enum { TIME_REFERENCE };

fmi3_status fmi3GetFloat64(fmi3_instance c, const fmi3_reference index[], size_t count,
                           double value[], size_t n_values)
{
    const fmi3_status wrong = check_counts(c, count, n_values);
    size_t begin = 0;
    if (wrong) return wrong;
    for (size_t k = 0; index && value && k < count; k++) { /* those between two that are the time */
        if (index[k] != TIME_REFERENCE) continue;
        const slave_answer answer =
            slave_get(c, TYPE_REAL, index + begin, k - begin, value + begin);
        if (answer) return status_of(answer);
        value[k] = slave_last_time(c);
        begin = k + 1;
    }
    return status_of(slave_get(c, TYPE_REAL, index ? index + begin : index, count - begin,
                               value ? value + begin : value));
}

CALL_FOR_VALUES(fmi3SetFloat64,
                (fmi3_instance c, const fmi3_reference index[], size_t count, const double value[],
                 size_t n_values),
                slave_set(c, TYPE_REAL, index, count, value, NULL))

CALL_FOR_VALUES(fmi3GetOutputDerivatives,
                (fmi3_instance c, const fmi3_reference index[], size_t count, const int32_t order[],
                 double value[], size_t n_values),
                slave_get_derivatives(c, index, count, order, value))

fmi3_status fmi3GetBoolean(fmi3_instance c, const fmi3_reference index[], size_t count,
                           fmi3_boolean value[], size_t n_values)
{
    fmi3_status status = check_counts(c, count, n_values);
    if (!status && count && !(index && value))
        return refuse(c, "value references or the place for values are missing");
    for (size_t k = 0; k < count && !status; k++) {
        int32_t truth;
        status = status_of(slave_get_truth(c, index[k], &truth));
        value[k] = truth != 0;
    }
    return status;
}

fmi3_status fmi3SetBoolean(fmi3_instance c, const fmi3_reference index[], size_t count,
                           const fmi3_boolean value[], size_t n_values)
{
    const fmi3_status wrong = check_counts(c, count, n_values);
    double truth[MOST_WORDS];
    for (size_t k = 0; value && k < count && k < MOST_WORDS; k++) truth[k] = value[k];
    return wrong ? wrong : status_of(slave_set_truths(c, index, count, value ? truth : NULL));
}

CALL_FOR_VALUES(fmi3GetString,
                (fmi3_instance c, const fmi3_reference index[], size_t count, fmi3_text value[],
                 size_t n_values),
                slave_get_words(c, index, count, value))
CALL_FOR_VALUES(fmi3SetString,
                (fmi3_instance c, const fmi3_reference index[], size_t count,
                 const fmi3_text value[], size_t n_values),
                slave_set_words(c, index, count, value))

/* --------------------------------------------------------------------------------------- states */

CALL(fmi3GetFMUState, (fmi3_instance c, fmi3_saved *state), slave_keep(c, (slave_kept **)state))
CALL(fmi3SetFMUState, (fmi3_instance c, fmi3_saved state), slave_return_to(c, state))
CALL(fmi3FreeFMUState, (fmi3_instance c, fmi3_saved *state), slave_free_kept((slave_kept **)state))
CALL(fmi3SerializedFMUStateSize, (fmi3_instance c, fmi3_saved state, size_t *size),
     slave_size_of_bytes(c, state, size))
CALL(fmi3SerializeFMUState, (fmi3_instance c, fmi3_saved state, fmi3_byte bytes[], size_t size),
     slave_bytes_of(c, state, bytes, size))
CALL(fmi3DeserializeFMUState,
     (fmi3_instance c, const fmi3_byte bytes[], size_t size, fmi3_saved *state),
     slave_kept_of(c, bytes, size, (slave_kept **)state))

/* ---------------------------------------------------------------------------- what is not there */

/* These look at their first arguments alone. All platforms that this is compiled for pass them as
   if there were no others. */
#define OTHER_TYPE(name)                                                                           \
    EXPORTED fmi3_status name(fmi3_instance c, const fmi3_reference index[], size_t count);        \
    fmi3_status name(fmi3_instance c, const fmi3_reference index[], size_t count)                  \
    {                                                                                              \
        (void)index;                                                                               \
        return c && !count                                                                         \
                   ? FMI3_OK                                                                       \
                   : refuse(c, "there are no variables of the type that " #name " is for");        \
    }
FMI3_OTHER_TYPES(OTHER_TYPE)

#define REFUSED(name)                                                                              \
    EXPORTED fmi3_status name(fmi3_instance c);                                                    \
    fmi3_status name(fmi3_instance c)                                                              \
    {                                                                                              \
        return refuse(c, #name                                                                     \
                      ": this FMU is for co-simulation without events, and has no such thing");    \
    }
FMI3_REFUSED(REFUSED)

#include "small.h"
