/* What the Python objects share: arrays in, numbers and bytes out. Checked are sizes, and that
 * numbers are finite. */
#ifndef SWARMGRASP_BINDING_H
#define SWARMGRASP_BINDING_H

#define PY_SSIZE_T_CLEAN
#define Py_LIMITED_API 0x030B0000
#include <Python.h>

#include "../status.h"

/* What takes long lets other threads run until it comes back. */
void leave(int is_long);
void come_back(void);

/* Raise what a status means: tells whether it is a fault, and then an exception is set. */
int is_raised(Status status);

/* Look at the keyboard: 1 if there is an exception. */
int interrupted(void);

/* Get C-contiguous doubles, a multiple of `width` of them. Returns 0, or -1 with an exception. */
int get_doubles(PyObject *object, Py_buffer *view, Py_ssize_t width);
int rows_of(const Py_buffer *view, int width);

/* Work out a row of `out` numbers for each row of `width` given: bytes, or NULL with an exception. */
PyObject *each_row(PyObject *rows, int width, int out, int is_long,
                   Status (*work_out)(void *of, const double *row, double *found), void *of);

/* Tell whether three numbers are finite; if not, set an exception. */
int are_finite(const double *v);

#endif
