/* Every function of FMI 2.0 co-simulation, called once or more in an order that the standard
   allows. A line for each, with its status, and lines with what it gave. */

#include "fmi2.h"

#include <stdio.h>
#include <stdlib.h>

enum { INPUT, OUTPUT, BOOLEAN, STRING };

static const double H = 0.05;

static void say(text what, int status)
{
    printf("%s %d\n", what, status);
}

static void show(text what, double value)
{
    printf("value of %s %.17g\n", what, value);
}

static void inquire(const struct fmu *fmu)
{
    printf("value of fmi2GetTypesPlatform %s\n", fmu->fmi2GetTypesPlatform());
    printf("value of fmi2GetVersion %s\n", fmu->fmi2GetVersion());
}

/* Before and in the initialization mode: log categories and values of all types. */
static void initialise(const struct fmu *fmu, component c, const reference *refs)
{
    text category = "logStatusError", word = NULL;
    boolean truth = 0;
    double push = 2.0, value = 0.0;
    say("fmi2SetDebugLogging", fmu->fmi2SetDebugLogging(c, 1, 1, &category));
    say("fmi2SetupExperiment", fmu->fmi2SetupExperiment(c, 0, 0.0, 0.0, 1, 10.0));
    say("fmi2SetBoolean", fmu->fmi2SetBoolean(c, &refs[BOOLEAN], 1, &truth));
    truth = 1;
    say("fmi2GetBoolean", fmu->fmi2GetBoolean(c, &refs[BOOLEAN], 1, &truth));
    show("fmi2GetBoolean", truth);
    word = "drawn";
    say("fmi2SetString", fmu->fmi2SetString(c, &refs[STRING], 1, &word));
    say("fmi2GetString", fmu->fmi2GetString(c, &refs[STRING], 1, &word));
    printf("value of fmi2GetString %s\n", word);
    say("fmi2EnterInitializationMode", fmu->fmi2EnterInitializationMode(c));
    say("fmi2SetReal", fmu->fmi2SetReal(c, &refs[INPUT], 1, &push));
    say("fmi2GetReal", fmu->fmi2GetReal(c, &refs[OUTPUT], 1, &value));
    show("fmi2GetReal", value);
    /* There are no Integer variables: lists of none. */
    say("fmi2SetInteger", fmu->fmi2SetInteger(c, NULL, 0, NULL));
    say("fmi2GetInteger", fmu->fmi2GetInteger(c, NULL, 0, NULL));
    say("fmi2ExitInitializationMode", fmu->fmi2ExitInitializationMode(c));
}

static double output_after_step(const struct fmu *fmu, component c, const reference *refs, double t)
{
    double value = 0.0;
    say("fmi2DoStep", fmu->fmi2DoStep(c, t, H, 0));
    say("fmi2GetReal", fmu->fmi2GetReal(c, &refs[OUTPUT], 1, &value));
    show("fmi2GetReal", value);
    return value;
}

/* The same step three times: straight, from a saved state, and from one that was made bytes. */
static void roll_back(const struct fmu *fmu, component c, const reference *refs)
{
    saved state = NULL, copy = NULL;
    size_t size = 0;
    say("fmi2GetFMUstate", fmu->fmi2GetFMUstate(c, &state));
    show("fmi2GetFMUstate", state != NULL);
    double straight = output_after_step(fmu, c, refs, H);
    say("fmi2SetFMUstate", fmu->fmi2SetFMUstate(c, state));
    say("repeated", output_after_step(fmu, c, refs, H) == straight ? FMI2_OK : FMI2_ERROR);
    say("fmi2SerializedFMUstateSize", fmu->fmi2SerializedFMUstateSize(c, state, &size));
    show("fmi2SerializedFMUstateSize", size > 0);
    byte *bytes = malloc(size);
    say("fmi2SerializeFMUstate", fmu->fmi2SerializeFMUstate(c, state, bytes, size));
    say("fmi2FreeFMUstate", fmu->fmi2FreeFMUstate(c, &state));
    show("fmi2FreeFMUstate", state == NULL);
    say("fmi2DeSerializeFMUstate", fmu->fmi2DeSerializeFMUstate(c, bytes, size, &copy));
    show("fmi2DeSerializeFMUstate", copy != NULL);
    say("fmi2SetFMUstate", fmu->fmi2SetFMUstate(c, copy));
    say("repeated", output_after_step(fmu, c, refs, H) == straight ? FMI2_OK : FMI2_ERROR);
    say("fmi2FreeFMUstate", fmu->fmi2FreeFMUstate(c, &copy));
    show("fmi2FreeFMUstate", copy == NULL);
    free(bytes);
}

static void ask_for_status(const struct fmu *fmu, component c)
{
    fmi2_status status = FMI2_OK;
    int pending = 0;
    boolean terminated = 1;
    double time = -1.0;
    text message = "";
    say("fmi2DoStep beyond the stop time", fmu->fmi2DoStep(c, 2.0 * H, 100.0, 1));
    say("fmi2GetRealStatus", fmu->fmi2GetRealStatus(c, FMI2_LAST_SUCCESSFUL_TIME, &time));
    show("fmi2GetRealStatus", time);
    say("fmi2GetBooleanStatus", fmu->fmi2GetBooleanStatus(c, FMI2_TERMINATED, &terminated));
    show("fmi2GetBooleanStatus", terminated);
    say("fmi2GetStatus", fmu->fmi2GetStatus(c, FMI2_DO_STEP_STATUS, &status));
    show("fmi2GetStatus", status);
    say("fmi2GetIntegerStatus", fmu->fmi2GetIntegerStatus(c, FMI2_DO_STEP_STATUS, &pending));
    show("fmi2GetIntegerStatus", pending);
    say("fmi2GetStringStatus", fmu->fmi2GetStringStatus(c, FMI2_PENDING_STATUS, &message));
}

/* What the model description does not promise. */
static void ask_for_more(const struct fmu *fmu, component c, const reference *refs)
{
    const int first = 1;
    double seed = 1.0, value = 0.0;
    say("fmi2SetRealInputDerivatives",
        fmu->fmi2SetRealInputDerivatives(c, &refs[INPUT], 1, &first, &seed));
    say("fmi2GetRealOutputDerivatives",
        fmu->fmi2GetRealOutputDerivatives(c, &refs[OUTPUT], 1, &first, &value));
    int status = fmu->fmi2GetDirectionalDerivative(c, &refs[OUTPUT], 1, &refs[INPUT], 1, &seed,
                                                   &value);
    say("fmi2GetDirectionalDerivative", status);
    say("fmi2CancelStep", fmu->fmi2CancelStep(c));
}

void call_every_function(const struct fmu *fmu, component c, const reference refs[4]);
void call_every_function(const struct fmu *fmu, component c, const reference refs[4])
{
    inquire(fmu);
    initialise(fmu, c, refs);
    double first = output_after_step(fmu, c, refs, 0.0);
    roll_back(fmu, c, refs);
    ask_for_status(fmu, c);
    ask_for_more(fmu, c, refs);
    say("fmi2Terminate", fmu->fmi2Terminate(c));
    say("fmi2Reset", fmu->fmi2Reset(c));
    initialise(fmu, c, refs);
    say("repeated", output_after_step(fmu, c, refs, 0.0) == first ? FMI2_OK : FMI2_ERROR);
    say("fmi2Terminate", fmu->fmi2Terminate(c));
    fmu->fmi2FreeInstance(c);
    say("fmi2FreeInstance", FMI2_OK);
}
