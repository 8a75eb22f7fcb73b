/* A host of native FMUs that hands them damaged model files and states, each with good checksums,
   for a library with sanitizers:

       native SEED FOLDER (LIBRARY MODEL STEP_SIZE LONGEST_STEP)...

   It reads the number of a case from each line of stdin and answers with one: what came of it, or
   "!" and what is wrong. FOLDER is where it writes model.bin, MODEL a good one, then come
   references of solver.step_size and solver.longest_step. What else ends it is a finding, too. */
#define _POSIX_C_SOURCE 200809L

#include "../c_host/fmi2.h"
#include "model_tables.h"

#include <dlfcn.h>
#include <math.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/time.h>

/* CPU_LIMIT: of one case, in s. To refuse a damaged mechanism that cannot be closed takes up to
   12 s, ten times that with sanitizers, and some machines are three times slower. */
enum {
    MOST_MODELS = 16,
    STEPS = 3,
    MOST_VALUES = 2000,
    CPU_LIMIT = 400,
    CHECKED_FROM = offsetof(hm_header, abi)
};
/* A state: that of the slave, its head and the numbers; its two checksums, and what each is of
   (slave_states.c, saved_state.c). */
enum { KEPT = 48, KEPT_CHECKSUM = 8, KEPT_CHECKED = 12, SAVED_CHECKSUM = 56, SAVED_HEAD = 64 };

struct target { struct fmu fmu; byte *model; size_t length; reference step_size[2]; };

static char path[4000], uri[4000], said[20000];
static const char *wrong;
static uint64_t chance_state;

/* --------------------------------------------------------------------------------------- chance */

static uint64_t chance(uint64_t end)
{
    uint64_t z = chance_state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (z ^ z >> 31) % end;
}

static void begin_case(text seed, long number)
{
    chance_state = 14695981039346656037u;
    for (; *seed; seed++) chance_state = (chance_state ^ (byte)*seed) * 1099511628211u;
    chance_state ^= (uint64_t)number * 0xd1342543de82ef95u;
}

static double some_number(void)
{
    static const double numbers[] = {0.0,    -1.0,   1.0, 3.0,      1e-9,     1e300,
                                     -1e300, 5e-324, NAN, INFINITY, -INFINITY};
    return numbers[chance(sizeof numbers / sizeof *numbers)];
}

/* --------------------------------------------------------------------------------------- damage */

static uint32_t checksum(const byte *bytes, size_t count)
{
    uint32_t crc = ~0u;
    for (; count; count--, bytes++) {
        crc ^= *bytes;
        for (int bit = 0; bit < 8; bit++) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
    }
    return ~crc;
}

static void change_word(byte *bytes, size_t length)
{
    static const int32_t words[] = {0, -1, 1, 2, 7, 100, INT32_MAX, INT32_MIN, 1 << 16, 1 << 26};
    const size_t at = 4 * chance(length / 4);
    int32_t word;
    memcpy(&word, bytes + at, 4);
    word = chance(3) ? (int32_t)((uint32_t)word + (uint32_t)chance(7) - 3u)
                     : words[chance(sizeof words / sizeof *words)];
    memcpy(bytes + at, &word, 4);
}

static void change_number(byte *bytes, size_t length)
{
    const double number = some_number();
    memcpy(bytes + 8 * chance(length / 8), &number, 8);
}

/* Changes words, numbers, bits or the length of so many bytes; the new length, at most 64 more. */
static size_t damage(byte *bytes, size_t length)
{
    for (uint64_t k = 1 + chance(3); k && length >= 16; k--) {
        const uint64_t kind = chance(20);
        const size_t at = chance(length), more = 1 + chance(60);
        if (kind < 8) change_word(bytes, length);
        else if (kind < 14) change_number(bytes, length);
        else if (kind < 18) bytes[at] ^= (byte)(1 << chance(8));
        else if (kind == 18) length = at;
        else if (k == 1) { /* the last change, as there is room for one */
            memmove(bytes + at + more, bytes + at, length - at);
            length += more;
        }
    }
    return length;
}

static size_t damaged_model(const struct target *t, byte *bytes)
{
    size_t length = t->length;
    hm_header header;
    memcpy(bytes, t->model, length);
    /* Some in the header and the sizes, which are few. */
    if (chance(4)) length = CHECKED_FROM + damage(bytes + CHECKED_FROM, length - CHECKED_FROM);
    else damage(bytes + CHECKED_FROM, 600);
    if (length < sizeof header || !chance(20)) return length;
    memcpy(&header, bytes, sizeof header);
    if (length != t->length && chance(8)) header.length = (uint32_t)length;
    memcpy(bytes, &header, sizeof header);
    header.checksum = checksum(bytes + CHECKED_FROM, length - CHECKED_FROM);
    memcpy(bytes, &header, sizeof header);
    return length;
}

static size_t damaged_state(byte *bytes, size_t length)
{
    const uint64_t where = chance(8);
    if (!where) length = damage(bytes, length);
    else if (where == 1) damage(bytes, KEPT + SAVED_HEAD);
    else if (where < 5) damage(bytes + KEPT + SAVED_HEAD, 8 * S_HEAD);
    else damage(bytes + KEPT + SAVED_HEAD, length - KEPT - SAVED_HEAD - 64);
    if (length < KEPT + SAVED_HEAD || !chance(20)) return length;
    uint32_t sum = checksum(bytes + KEPT_CHECKED, KEPT - KEPT_CHECKED);
    memcpy(bytes + KEPT_CHECKSUM, &sum, 4);
    memset(bytes + KEPT + SAVED_CHECKSUM, 0, 4);
    sum = checksum(bytes + KEPT, length - KEPT);
    memcpy(bytes + KEPT + SAVED_CHECKSUM, &sum, 4);
    return length;
}

/* ----------------------------------------------------------------------------------------- host */

/* As hosts do, it takes the text for a format. */
static void hear(void *environment, text instance, fmi2_status status, text category, text message,
                 ...)
{
    (void)environment, (void)instance, (void)status, (void)category;
    va_list arguments;
    va_start(arguments, message);
    vsnprintf(said, sizeof said, message, arguments);
    va_end(arguments);
}

static const fmi2_callbacks CALLBACKS = {hear, calloc, free, NULL, NULL};

/* A call that is refused says why. */
static fmi2_status answered(fmi2_status status, text name)
{
    if (status > FMI2_WARNING && !*said) wrong = name;
    if (status >= FMI2_FATAL) wrong = name;
    *said = 0;
    return status;
}
#define CALL(name, ...) answered(f->name(__VA_ARGS__), #name)

/* Reads what can be read: numbers are finite, words end. */
static void read_all(const struct fmu *f, component c, uint32_t n_variables)
{
    for (reference k = 0; k < n_variables && k < MOST_VALUES; k++) {
        double value = 0.0;
        boolean truth = 0;
        text word = NULL;
        if (!CALL(fmi2GetReal, c, &k, 1, &value) && !(fabs(value) < INFINITY))
            wrong = "a value that is not finite";
        CALL(fmi2GetBoolean, c, &k, 1, &truth);
        if (!CALL(fmi2GetString, c, &k, 1, &word) && !(word && strlen(word) < 1000))
            wrong = "a word that does not end";
    }
}

static void change_some(const struct fmu *f, component c, uint32_t n_variables)
{
    for (uint64_t k = chance(4); k; k--) {
        const reference which = (reference)chance((uint64_t)n_variables + 2);
        const double value = chance(2) ? some_number() : 0.1 * (double)chance(20);
        const boolean truth = (int)chance(2);
        CALL(fmi2SetReal, c, &which, 1, &value);
        CALL(fmi2SetBoolean, c, &which, 1, &truth);
    }
}

/* Steps of an instance, of a length that needs few internal ones; how many were taken. */
static int move(const struct target *t, component c, double time, uint32_t n_variables)
{
    const struct fmu *f = &t->fmu;
    int taken = 0;
    for (int k = 0; k < STEPS; k++) {
        double longest[2] = {0.0, 0.0}, step = 0.01;
        CALL(fmi2GetReal, c, t->step_size, 2, longest);
        for (int i = 0; i < 2; i++) step = longest[i] > 0.0 ? fmin(step, 2.0 * longest[i]) : step;
        if (CALL(fmi2DoStep, c, time, step, 1)) continue;
        time += step, taken++;
        if (k == 1) change_some(f, c, n_variables);
    }
    read_all(f, c, n_variables);
    return taken;
}

/* Goes on from a damaged state, which is refused or taken. */
static text from_damaged_state(const struct target *t, component c, uint32_t n_variables)
{
    const struct fmu *f = &t->fmu;
    saved state = NULL, other = NULL;
    size_t size = 0;
    if (CALL(fmi2GetFMUstate, c, &state) || CALL(fmi2SerializedFMUstateSize, c, state, &size))
        return "no state";
    byte *bytes = malloc(size + 64);
    CALL(fmi2SerializeFMUstate, c, state, bytes, size);
    const size_t length = damaged_state(bytes, size);
    byte *exact = malloc(length + !length); /* what lies behind it is nobody's */
    memcpy(exact, bytes, length);
    free(bytes);
    text outcome = "state refused";
    if (!CALL(fmi2DeSerializeFMUstate, c, exact, length, &other)) {
        double time = 0.0;
        free(exact);
        exact = NULL;
        if (CALL(fmi2SetFMUstate, c, other)) outcome = "state not set";
        else {
            CALL(fmi2GetRealStatus, c, FMI2_LAST_SUCCESSFUL_TIME, &time);
            outcome =
                move(t, c, time, n_variables) ? "state taken, moved" : "state taken, not moved";
        }
        CALL(fmi2FreeFMUstate, c, &other);
    }
    free(exact);
    if (!CALL(fmi2SetFMUstate, c, state)) move(t, c, 0.0, n_variables);
    CALL(fmi2FreeFMUstate, c, &state);
    return outcome;
}

static text run(const struct target *t, component c, uint32_t n_variables, int is_model)
{
    const struct fmu *f = &t->fmu;
    text outcome = "model: not assembled";
    if (chance(4) == 0) change_some(f, c, n_variables);
    if (chance(4) == 0) read_all(f, c, n_variables);
    CALL(fmi2SetupExperiment, c, (int)chance(2), 1e-4, 0.0, 0, 0.0);
    CALL(fmi2EnterInitializationMode, c);
    if (!CALL(fmi2ExitInitializationMode, c)) {
        const int taken = move(t, c, 0.0, n_variables);
        outcome = taken == STEPS ? "model: moved"
                  : taken        ? "model: moved in part"
                                 : "model: not moved";
    }
    if (!is_model) outcome = from_damaged_state(t, c, n_variables);
    else if (chance(8) == 0) from_damaged_state(t, c, n_variables);
    if (chance(4) == 0) CALL(fmi2Reset, c);
    return outcome;
}

/* Runs a damaged model, or from a damaged state of a good one. */
static text run_case(const struct target *t)
{
    const int is_model = chance(2);
    byte *bytes = malloc(t->length + 64);
    size_t length = t->length;
    memcpy(bytes, t->model, length);
    if (is_model) length = damaged_model(t, bytes);
    hm_header header;
    memcpy(&header, length >= sizeof header ? bytes : t->model, sizeof header);
    header.guid[sizeof header.guid - 1] = 0;
    FILE *file = fopen(path, "wb");
    if (!file || fwrite(bytes, 1, length, file) != length || fclose(file)) exit(3);
    free(bytes);
    *said = 0;
    component c = t->fmu.fmi2Instantiate("x", FMI2_CO_SIMULATION, header.guid, uri, &CALLBACKS, 0,
                                         (int)chance(2));
    if (!c && !*said) wrong = "no instance and no sentence";
    *said = 0;
    if (!c) return "model: refused";
    text outcome = run(t, c, header.n_variables, is_model);
    t->fmu.fmi2FreeInstance(c);
    return outcome;
}

static struct target load(text library, text model, text step_size, text longest_step)
{
    struct target t = {.step_size = {(reference)atoi(step_size), (reference)atoi(longest_step)}};
    FILE *file = fopen(model, "rb");
    t.fmu.library = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    if (!t.fmu.library || !file) {
        fprintf(stderr, "%s\n", t.fmu.library ? model : dlerror());
        exit(3);
    }
#define LOAD(result, name, arguments) *(void **)&t.fmu.name = dlsym(t.fmu.library, #name);
    FMI2_FUNCTIONS(LOAD)
    fseek(file, 0, SEEK_END);
    t.length = (size_t)ftell(file);
    rewind(file);
    t.model = malloc(t.length);
    if (fread(t.model, 1, t.length, file) != t.length) exit(3);
    fclose(file);
    return t;
}

int main(int count, char **word)
{
    static struct target targets[MOST_MODELS];
    int n_targets = 0;
    long number;
    const struct itimerval limit = {.it_value = {CPU_LIMIT, 0}};
    for (int k = 3; k + 3 < count && n_targets < MOST_MODELS; k += 4)
        targets[n_targets++] = load(word[k], word[k + 1], word[k + 2], word[k + 3]);
    if (!n_targets) return 3;
    snprintf(path, sizeof path, "%s/model.bin", word[2]);
    snprintf(uri, sizeof uri, "file://%s", word[2]);
    while (scanf("%ld", &number) == 1) {
        begin_case(word[1], number);
        wrong = NULL;
        setitimer(ITIMER_VIRTUAL, &limit, NULL); /* its signal ends the program */
        text outcome = run_case(&targets[chance((uint64_t)n_targets)]);
        printf("%s%s\n", wrong ? "! " : "", wrong ? wrong : outcome);
        fflush(stdout);
    }
    return 0;
}
