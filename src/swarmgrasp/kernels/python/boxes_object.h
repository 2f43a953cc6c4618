/* Searches over boxes as Python objects, of a type that each copy of the module has for itself. */
#ifndef SWARMGRASP_BOXES_OBJECT_H
#define SWARMGRASP_BOXES_OBJECT_H

#include "../boxes.h"
#include "binding.h"

#define TERM_ROW (5 + LOST)              /* numbers of a term, and of a box: what it holds, its */
#define BOX_ROW (6 + TERM_ROW * CORNERS) /* bound, and its terms */

/* Make the type of a module's searches over boxes. Returns NULL with an exception. */
PyObject *make_boxes_type(PyObject *module);

#endif
