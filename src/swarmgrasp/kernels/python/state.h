/* What each copy of the core module has for itself: the types of what its objects take. */
#ifndef SWARMGRASP_STATE_H
#define SWARMGRASP_STATE_H

#include "binding.h"

typedef struct {
    PyObject *criterion_type, *sets_type;
} State;

#endif
