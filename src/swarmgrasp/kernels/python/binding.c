/* Buffers, threads, the keyboard and statuses, for all files here. What callers of Python may get
 * wrong is checked here and in the files beside, so that kernels can trust it. */
#include <math.h>

#include "binding.h"

#ifdef _MSC_VER /* whose C11 has had the keyword for a few years only */
#define OF_THREAD __declspec(thread)
#else
#define OF_THREAD _Thread_local
#endif

/* The thread's state while what it does leaves the interpreter to others, or NULL. */
static OF_THREAD PyThreadState *away;

void leave(int is_long) {
    if (is_long)
        away = PyEval_SaveThread();
}

void come_back(void) {
    if (away)
        PyEval_RestoreThread(away);
    away = NULL;
}

int interrupted(void) {
    int was_away = away != NULL;
    come_back();
    int status = PyErr_CheckSignals() != 0;
    leave(was_away);
    return status;
}

int is_raised(Status status) {
    switch (status) {
    case SOLVED:
    case OUT_OF_BUDGET:
    case REACHED:
    case REFUTED:
    case CAPPED:
    case INTERRUPTED: /* what was pressed is set already */
        break;
    case NO_MEMORY:
        PyErr_NoMemory();
        break;
    case UNSORTED:
        PyErr_SetString(PyExc_ValueError, "rows should be sorted by robot: 0, 1, 2, ...");
    }
    return is_fault(status);
}

int get_doubles(PyObject *object, Py_buffer *view, Py_ssize_t width) {
    if (PyObject_GetBuffer(object, view, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT))
        return -1;
    if (view->itemsize != sizeof(double) || !view->format || view->format[0] != 'd'
        || view->len % (width * (Py_ssize_t)sizeof(double))
        || view->len / (width * (Py_ssize_t)sizeof(double)) > INT_MAX / 16) {
        PyErr_Format(PyExc_ValueError, "float64 in rows of %zd are wanted", width);
        PyBuffer_Release(view);
        return -1;
    }
    const double *values = view->buf;
    double sum = 0.0; /* of zeros, as long as all are finite */
    for (Py_ssize_t k = 0; k < view->len / (Py_ssize_t)sizeof(double); k++)
        sum += 0.0 * values[k];
    if (sum != 0.0) {
        PyErr_SetString(PyExc_ValueError, "finite numbers are wanted");
        PyBuffer_Release(view);
        return -1;
    }
    return 0;
}

int are_finite(const double *v) {
    if (isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]))
        return 1;
    PyErr_SetString(PyExc_ValueError, "finite numbers are wanted");
    return 0;
}

int rows_of(const Py_buffer *view, int width) {
    return (int)(view->len / (width * (Py_ssize_t)sizeof(double)));
}

PyObject *each_row(PyObject *rows, int width, int out, int is_long,
                   Status (*work_out)(void *of, const double *row, double *found), void *of) {
    Py_buffer view;
    if (get_doubles(rows, &view, width))
        return NULL;
    int count = rows_of(&view, width);
    PyObject *result = PyBytes_FromStringAndSize(NULL, out * count * (Py_ssize_t)sizeof(double));
    if (result) {
        double *found = (double *)PyBytes_AsString(result);
        const double *row = view.buf;
        Status status = SOLVED;
        leave(is_long);
        for (int k = 0; k < count && !is_fault(status); k++)
            status = work_out(of, row + (Py_ssize_t)width * k, found + (Py_ssize_t)out * k);
        come_back();
        if (is_raised(status))
            Py_CLEAR(result);
    }
    PyBuffer_Release(&view);
    return result;
}
