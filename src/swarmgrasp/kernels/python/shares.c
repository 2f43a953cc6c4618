/* The least shares as a Python module. Checked are sizes and finite numbers; what is returned has
 * 8 (n + 15) bytes a wrench. */
#include "../forces.h"
#include "../proven.h"
#include "binding.h"

#define ENOUGH 100000 /* robots times wrenches between two looks at the keyboard */

/* Write a row of shares and what they are worth for each wrench, the first search starting from a
 * normal, or 0. */
static Status fill_rows(Turning *turning, const double *wrenches, Py_ssize_t many, const double *load,
                        const double *start, double *row) {
    Shares found = {.normals = {{start[0], start[1], start[2]}}};
    Py_ssize_t work = 0; /* since the keyboard was looked at */
    for (Py_ssize_t k = 0; k < many; k++, row += turning->n + SHARES) {
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

/* least_shares(generators, wrenches, load, start) -> bytes */
static PyObject *shares_least(PyObject *module, PyObject *args) {
    PyObject *generators, *wrenches, *result = NULL;
    Py_buffer robots, wanted;
    double load[3], start[3] = {0.0};
    (void)module;
    if (!PyArg_ParseTuple(args, "OO(ddd)|(ddd):least_shares", &generators, &wrenches, load,
                          load + 1, load + 2, start, start + 1, start + 2)
        || !are_finite(load) || !are_finite(start) || get_doubles(generators, &robots, 3))
        return NULL;
    if (get_doubles(wrenches, &wanted, 3)) {
        PyBuffer_Release(&robots);
        return NULL;
    }
    Py_ssize_t n = rows_of(&robots, 3), many = rows_of(&wanted, 3);
    Turning turning = {0};
    Status status = NO_MEMORY;
    if (many <= PY_SSIZE_T_MAX / (Py_ssize_t)sizeof(double) / (n + SHARES))
        result = PyBytes_FromStringAndSize(NULL, many * (n + SHARES) * (Py_ssize_t)sizeof(double));
    if (result && (status = turning_room(&turning, robots.buf, n, interrupted)) == SOLVED) {
        leave(n * many > 4096);
        status = fill_rows(&turning, wanted.buf, many, load, start,
                           (double *)PyBytes_AsString(result));
        come_back();
    }
    turning_free(&turning);
    PyBuffer_Release(&robots);
    PyBuffer_Release(&wanted);
    if (is_raised(status))
        Py_CLEAR(result);
    return result;
}

static PyMethodDef methods[] = {
    {"least_shares", shares_least, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "shares", .m_slots = slots, .m_methods = methods,
};

PyMODINIT_FUNC PyInit_shares(void) { return PyModuleDef_Init(&definition); }
