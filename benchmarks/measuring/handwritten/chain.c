/* A hundred points in space. */
#define N 100
#define DIM 3
#define ADVANCE advance_chain
#include "point_chain.h"
