/* The least shares as a Python module. Checked are sizes, finite numbers, and that elements are
 * those of the robots given; what is returned has 8 (n + 15) bytes a wrench, or 8 (3 n + 13) for
 * robots of any force set. */
#include "binding.h"

#include "../forces.h"
#include "../proven.h"
#include "../pushers.h"

#include <string.h>

#define ENOUGH 100000 /* robots times wrenches between two looks at the keyboard */

/* Write a row of shares and what they are worth for each wrench. A search starts from a normal of its
 * own, if starts (m, 3) are given, otherwise from that of the row before. */
static Status fill_rows(Turning *turning, const double *wrenches, Py_ssize_t many, const double *load,
                        const double *starts, double *row) {
    Shares found = {.needed = 0.0};
    Py_ssize_t work = 0; /* since the keyboard was looked at */
    for (Py_ssize_t k = 0; k < many; k++, row += turning->n + SHARES) {
        if (starts)
            memcpy(found.normals[0], starts + 3 * k, 3 * sizeof *starts);
        Status status = least_shares(turning, wrenches + 3 * k, load, row, &found);
        if (status != SOLVED)
            return status;
        double *worth = row + turning->n;
        *worth++ = found.needed;
        *worth++ = found.shortfall;
        for (int c = 0; c < 9; c++)
            *worth++ = found.normals[c / 3][c % 3];
        for (int c = 0; c < 3; c++)
            *worth++ = found.price[c];
        *worth = shares_are_proven(turning, wrenches + 3 * k, load, row, &found);
        work += turning->n + 16;
        if (work > ENOUGH) {
            work = 0;
            if (interrupted())
                return INTERRUPTED;
        }
    }
    return SOLVED;
}

/* least_shares(generators, wrenches, load, starts) -> bytes */
static PyObject *shares_least(PyObject *module, PyObject *args) {
    enum { ROBOTS, WANTED, STARTS };
    PyObject *array[3] = {NULL}, *result = NULL;
    Py_buffer view[3];
    double load[3];
    (void)module;
    if (!PyArg_ParseTuple(args, "OO(ddd)|O:least_shares", array + ROBOTS, array + WANTED, load,
                          load + 1, load + 2, array + STARTS)
        || !are_finite(load))
        return NULL;
    int got = 0;
    while (got < 3 && array[got] && get_doubles(array[got], view + got, 3) == 0)
        got++;
    if (got < STARTS || (got == STARTS && array[STARTS]))
        goto done;
    Py_ssize_t n = rows_of(view + ROBOTS, 3), many = rows_of(view + WANTED, 3);
    if (got > STARTS && rows_of(view + STARTS, 3) != many) {
        PyErr_SetString(PyExc_ValueError, "a start for each wrench is wanted");
        goto done;
    }
    Turning turning = {0};
    Status status = NO_MEMORY;
    if (many <= PY_SSIZE_T_MAX / (Py_ssize_t)sizeof(double) / (n + SHARES))
        result = PyBytes_FromStringAndSize(NULL, many * (n + SHARES) * (Py_ssize_t)sizeof(double));
    if (result && (status = turning_room(&turning, view[ROBOTS].buf, n, interrupted)) == SOLVED) {
        leave(n * many > 4096);
        status = fill_rows(&turning, view[WANTED].buf, many, load,
                           got > STARTS ? view[STARTS].buf : NULL,
                           (double *)PyBytes_AsString(result));
        come_back();
    }
    turning_free(&turning);
    if (is_raised(status))
        Py_CLEAR(result);
done:
    while (got-- > 0)
        PyBuffer_Release(view + got);
    return result;
}

#define PUSH 13 /* numbers in a row beside forces and shares */

/* Write a row of forces, shares and what they are worth for each wrench. */
static Status fill_pushes(Pushers *pushers, const double *wrenches, int many, const double *load,
                          double *row) {
    Work work = work_of(INFINITY, interrupted);
    double held = length(load);
    for (int k = 0; k < many; k++, wrenches += 3) {
        Push found;
        double wanted[3] = {wrenches[0] - load[0], wrenches[1] - load[1], wrenches[2] - load[2]};
        double *shares = row + 2 * pushers->count, *worth = shares + pushers->count;
        Status status = push(pushers, wanted, length(wrenches) + held, &work, row, shares, &found);
        if (status != SOLVED)
            return status;
        *worth++ = found.needed;
        *worth++ = found.shortfall;
        for (int c = 0; c < 6; c++)
            *worth++ = found.normals[c / 3][c % 3];
        for (int c = 0; c < 3; c++)
            *worth++ = found.price[c];
        *worth++ = found.is_even;
        *worth++ = found.is_proven;
        row = worth;
    }
    return SOLVED;
}

/* Tell whether counts (n,) are those of elements, each robot having one at least; if not, set an
 * exception. */
static int add_up(const double *counts, int n, int rows) {
    double all = 0.0;
    for (int i = 0; i < n; i++) {
        if (!(counts[i] >= 1.0 && counts[i] <= rows && counts[i] == (double)(int)counts[i]))
            all = INFINITY;
        all += counts[i];
    }
    if (all == (double)rows)
        return 1;
    PyErr_SetString(PyExc_ValueError, "counts should be whole numbers that add up to the elements");
    return 0;
}

/* push_forces(arms, elements, counts, scale, wrenches, load) -> bytes */
static PyObject *shares_push(PyObject *module, PyObject *args) {
    enum { ARMS, ELEMENTS, COUNTS, WRENCHES, ARRAYS };
    static const int width[ARRAYS] = {2, ELEMENT, 1, 3};
    PyObject *array[ARRAYS], *result = NULL;
    Py_buffer view[ARRAYS];
    double s[3], load[3];
    (void)module;
    if (!PyArg_ParseTuple(args, "OOO(ddd)O(ddd):push_forces", array + ARMS, array + ELEMENTS,
                          array + COUNTS, s, s + 1, s + 2, array + WRENCHES, load, load + 1, load + 2)
        || !are_finite(s) || !are_finite(load))
        return NULL;
    int got = 0;
    while (got < ARRAYS && get_doubles(array[got], view + got, width[got]) == 0)
        got++;
    if (got < ARRAYS)
        goto done;
    int n = rows_of(view + ARMS, 2), many = rows_of(view + WRENCHES, 3);
    if (rows_of(view + COUNTS, 1) != n) {
        PyErr_SetString(PyExc_ValueError, "a count for each arm is wanted");
        goto done;
    }
    if (!add_up(view[COUNTS].buf, n, rows_of(view + ELEMENTS, ELEMENT)))
        goto done;
    Py_ssize_t row = (3 * (Py_ssize_t)n + PUSH) * (Py_ssize_t)sizeof(double);
    Pushers pushers = {0};
    Status status = NO_MEMORY;
    if (many <= PY_SSIZE_T_MAX / row)
        result = PyBytes_FromStringAndSize(NULL, many * row);
    if (result) {
        leave((double)n * many > 500.0);
        status = pushers_begin(&pushers, s, n, view[ARMS].buf, view[ELEMENTS].buf, view[COUNTS].buf);
        if (status == SOLVED)
            status = fill_pushes(&pushers, view[WRENCHES].buf, many, load,
                                 (double *)PyBytes_AsString(result));
        pushers_end(&pushers);
        come_back();
    }
    if (is_raised(status))
        Py_CLEAR(result);
done:
    while (got-- > 0)
        PyBuffer_Release(view + got);
    return result;
}

static PyMethodDef methods[] = {
    {"least_shares", shares_least, METH_VARARGS, NULL},
    {"push_forces", shares_push, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "shares", .m_slots = slots, .m_methods = methods,
};

PyMODINIT_FUNC PyInit_shares(void) { return PyModuleDef_Init(&definition); }
