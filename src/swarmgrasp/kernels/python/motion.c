/* Motion as a Python module. Checked are sizes, finite numbers, and what robots follow; returned are
 * 8 (6 + 2 n) bytes for each run, or 72. */
#include "binding.h"

#include "../motion.h"

#include <math.h>
#include <string.h>

#define NUMBER ((Py_ssize_t)sizeof(double))
#define OBJECT ((int)(sizeof(Afloat) / sizeof(double)))
#define ROBOT ((int)(sizeof(Driver) / sizeof(double)))
#define SHORT 300 /* steps of a robot that are not worth leaving the interpreter for */

/* An object, its robots and their states, then a row of other numbers for each run: all that are asked
 * about. */
enum { HULL, DRIVERS, STATES, STREAMS, ORDERS, LOADS, ARRAYS };

typedef struct {
    Py_buffer view[ARRAYS];
    int got, n, runs;
} Asked;

static void release(Asked *asked) {
    while (asked->got > 0)
        PyBuffer_Release(asked->view + --asked->got);
}

/* Tell whether each robot follows orders in a way that there is. */
static int are_followers(const Driver *driver, int n) {
    for (int i = 0; i < n; i++)
        if (!(driver[i].following >= FIXED && driver[i].following <= FREE))
            return 0;
    return 1;
}

/* Get the first `count` arrays. Returns 0, or -1 with an exception. */
static int get_asked(PyObject *const *array, int count, Asked *asked) {
    asked->got = 0;
    while (asked->got < count) {
        int width = asked->got == HULL ? OBJECT : asked->got == DRIVERS ? ROBOT : 1;
        if (get_doubles(array[asked->got], asked->view + asked->got, width))
            break;
        asked->got++;
    }
    if (asked->got < count) {
        release(asked);
        return -1;
    }
    asked->n = rows_of(asked->view + DRIVERS, ROBOT);
    const int width[ARRAYS] = {OBJECT, ROBOT, BODY + 2 * asked->n, STREAM, 2 * asked->n, 3};
    asked->runs = rows_of(asked->view + STATES, width[STATES]);
    int is_so = rows_of(asked->view + HULL, OBJECT) == 1;
    for (int k = STATES; k < count && is_so; k++)
        is_so = asked->view[k].len == (Py_ssize_t)asked->runs * width[k] * NUMBER;
    if (is_so && are_followers(asked->view[DRIVERS].buf, asked->n))
        return 0;
    release(asked);
    PyErr_SetString(PyExc_ValueError,
                    "one object, robots that follow orders, and a row of each array for each run are "
                    "wanted");
    return -1;
}

/* advance(hull, drivers, states, streams, orders, loads, step, steps) -> bytes */
static PyObject *motion_module_advance(PyObject *module, PyObject *args) {
    PyObject *array[ARRAYS], *result = NULL;
    Asked asked;
    double step;
    long steps;
    (void)module;
    if (!PyArg_ParseTuple(args, "OOOOOOdl:advance", array, array + 1, array + 2, array + 3, array + 4,
                          array + 5, &step, &steps))
        return NULL;
    if (!isfinite(step) || step <= 0.0 || steps < 0) {
        PyErr_SetString(PyExc_ValueError, "a positive step and a number of steps are wanted");
        return NULL;
    }
    if (get_asked(array, ARRAYS, &asked))
        return NULL;
    Py_buffer *view = asked.view;
    result = PyBytes_FromStringAndSize(NULL, view[STATES].len);
    if (result) {
        double *state = (double *)PyBytes_AsString(result);
        Work work = work_of(INFINITY, interrupted);
        memcpy(state, view[STATES].buf, (size_t)view[STATES].len);
        leave((double)asked.runs * (double)steps * (1.0 + asked.n) > SHORT);
        Status status = motion_advance(view[HULL].buf, view[DRIVERS].buf, asked.n, asked.runs, state,
                                       view[ORDERS].buf, view[STREAMS].buf, view[LOADS].buf, step,
                                       steps, &work);
        come_back();
        if (is_raised(status))
            Py_CLEAR(result);
    }
    release(&asked);
    return result;
}

/* exerted(hull, drivers, states, streams) -> bytes */
static PyObject *motion_module_exerted(PyObject *module, PyObject *args) {
    PyObject *array[ARRAYS];
    Asked asked;
    (void)module;
    if (!PyArg_ParseTuple(args, "OOOO:exerted", array, array + 1, array + 2, array + 3)
        || get_asked(array, ORDERS, &asked))
        return NULL;
    PyObject *result = PyBytes_FromStringAndSize(NULL, EXERTED * NUMBER * asked.runs);
    if (result)
        motion_exerted(asked.view[HULL].buf, asked.view[DRIVERS].buf, asked.n, asked.runs,
                       asked.view[STATES].buf, asked.view[STREAMS].buf,
                       (double *)PyBytes_AsString(result));
    release(&asked);
    return result;
}

static PyMethodDef methods[] = {
    {"advance", motion_module_advance, METH_VARARGS, NULL},
    {"exerted", motion_module_exerted, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "motion", .m_slots = slots, .m_methods = methods,
};

PyMODINIT_FUNC PyInit_motion(void) { return PyModuleDef_Init(&definition); }
