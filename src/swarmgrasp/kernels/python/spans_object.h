/* Searches over spans as Python objects, of a type that each copy of the module has for itself. */
#ifndef SWARMGRASP_SPANS_OBJECT_H
#define SWARMGRASP_SPANS_OBJECT_H

#include "../spans.h"
#include "binding.h"

#define SPAN_ROW 13 /* numbers that a span is told in: piece, from, to, bound, kind, and two terms */

/* Make the type of a module's searches over spans. Returns NULL with an exception. */
PyObject *make_spans_type(PyObject *module);

#endif
