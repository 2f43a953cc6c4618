/* Criteria as Python objects, of a type that each copy of the module has for itself. */
#ifndef SWARMGRASP_CRITERION_OBJECT_H
#define SWARMGRASP_CRITERION_OBJECT_H

#include "../criterion.h"
#include "binding.h"

/* Make the type of a module's criteria. Returns NULL with an exception. */
PyObject *make_criterion_type(PyObject *module);

/* The criterion of an object of that type; NULL with an exception for any other object. */
const Criterion *criterion_of(PyObject *type, PyObject *object);

#endif
