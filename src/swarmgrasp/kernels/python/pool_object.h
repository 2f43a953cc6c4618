/* Searches beside sets of forces as Python objects, of types that each copy of the module has for
 * itself. */
#ifndef SWARMGRASP_POOL_OBJECT_H
#define SWARMGRASP_POOL_OBJECT_H

#include "../boxes.h"
#include "../spans.h"
#include "binding.h"

#define TERM_ROW (5 + LOST)              /* numbers of a term, and of a box: what it holds, its */
#define BOX_ROW (6 + TERM_ROW * CORNERS) /* bound, and its terms */
#define SPAN_ROW 13                      /* and of a span */

/* Make the types of a module's searches over boxes and over spans. Return NULL with an exception. */
PyObject *make_boxes_type(PyObject *module);
PyObject *make_spans_type(PyObject *module);

#endif
