/* Sets of forces as Python objects, of a type that each copy of the module has for itself. */
#ifndef SWARMGRASP_SETS_OBJECT_H
#define SWARMGRASP_SETS_OBJECT_H

#include "../sets.h"
#include "binding.h"

/* Make the type of a module's sets. Returns NULL with an exception. */
PyObject *make_sets_type(PyObject *module);

/* The sets of an object of that type; NULL with an exception for any other object. */
const Sets *sets_of(PyObject *type, PyObject *object);

#endif
