/* A host in C++ of native FMUs: COUNT instances at once, each in a thread of its own, behind one that is alone:

       threads FMI LIBRARY RESOURCES TOKEN INPUT OUTPUT COUNT

   RESOURCES is a URI in FMI 2 and a path in FMI 3. The last output of each goes to stdout, that of the one alone first. */
#include "../../fmu_src/native/fmi2.h"
#include "../../fmu_src/native/fmi3.h"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <thread>
#include <vector>

namespace {

constexpr int STEPS = 50;
constexpr double H = 0.01;

#define POINTER(result, name, arguments) result (*name) arguments;
struct functions {
    FMI2_FUNCTIONS(POINTER)
    FMI3_FUNCTIONS(POINTER)
};

struct job {
    functions f;
    bool is_fmi3;
    const char *resources, *token;
    unsigned input, output;
};

void must(int status)
{
    if (status != 0) std::exit(2);
}

void hear2(void *, fmi2_text, fmi2_status, fmi2_text, fmi2_text text, ...) { std::fprintf(stderr, "%s\n", text); }
void hear3(void *, fmi3_status, fmi3_text, fmi3_text text) { std::fprintf(stderr, "%s\n", text); }

double run2(const job &j)
{
    const functions &f = j.f;
    const fmi2_callbacks callbacks = {hear2, std::calloc, std::free, nullptr, nullptr};
    double value = 0.0;
    fmi2_component c = f.fmi2Instantiate("x", FMI2_CO_SIMULATION, j.token, j.resources, &callbacks, 0, 0);
    if (!c) std::exit(2);
    must(f.fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0));
    must(f.fmi2EnterInitializationMode(c));
    must(f.fmi2ExitInitializationMode(c));
    for (int i = 0; i < STEPS; i++) {
        const double push = 1.0 + i;
        must(f.fmi2SetReal(c, &j.input, 1, &push));
        must(f.fmi2DoStep(c, i * H, H, 1));
        must(f.fmi2GetReal(c, &j.output, 1, &value));
    }
    f.fmi2FreeInstance(c);
    return value;
}

double run3(const job &j)
{
    const functions &f = j.f;
    double value = 0.0, last;
    bool event, end, early;
    fmi3_instance c = f.fmi3InstantiateCoSimulation("x", j.token, j.resources, false, false, false, false, nullptr, 0, nullptr, hear3, nullptr);
    if (!c) std::exit(2);
    must(f.fmi3EnterInitializationMode(c, false, 0.0, 0.0, false, 0.0));
    must(f.fmi3ExitInitializationMode(c));
    for (int i = 0; i < STEPS; i++) {
        const double push = 1.0 + i;
        must(f.fmi3SetFloat64(c, &j.input, 1, &push, 1));
        must(f.fmi3DoStep(c, i * H, H, true, &event, &end, &early, &last));
        must(f.fmi3GetFloat64(c, &j.output, 1, &value, 1));
    }
    f.fmi3FreeInstance(c);
    return value;
}

} // namespace

int main(int count, char **word)
{
    void *library = count == 8 ? dlopen(word[2], RTLD_NOW | RTLD_LOCAL) : nullptr;
    if (!library) return 1;
    job j = {{}, word[1][0] == '3', word[3], word[4], unsigned(std::atoi(word[5])), unsigned(std::atoi(word[6]))};
#define LOAD(result, name, arguments) j.f.name = reinterpret_cast<result(*) arguments>(dlsym(library, #name));
    FMI2_FUNCTIONS(LOAD)
    FMI3_FUNCTIONS(LOAD)
    const auto run = j.is_fmi3 ? run3 : run2;
    std::vector<double> values(1 + unsigned(std::atoi(word[7])));
    std::vector<std::thread> threads;
    values[0] = run(j);
    for (std::size_t i = 1; i < values.size(); i++) threads.emplace_back([&, i] { values[i] = run(j); });
    for (std::thread &thread : threads) thread.join();
    for (double value : values) std::printf("%.17g\n", value);
    return 0;
}
