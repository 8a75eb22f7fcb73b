/* Two points in the plane. */
#define N 2
#define DIM 2
#define ADVANCE advance_double_pendulum
#include "point_chain.h"
