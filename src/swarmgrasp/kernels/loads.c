/* The least loads as a Python module. */
#include "binding.h"
#include "forces.h"

#define ENOUGH 100000 /* robots times wrenches between two looks at the keyboard */

/* Write a row of loads and what they are worth for each wrench. Returns 0, -1 without memory, -2 if
 * stopped. */
static int fill_rows(Crew *crew, const double *wrenches, Py_ssize_t many, const double *load,
                     double *row) {
    Loads found = {0};
    Py_ssize_t work = 0; /* since the keyboard was looked at */
    int status = 0;
    for (Py_ssize_t k = 0; k < many && status == 0; k++, row += crew->n + LOADS) {
        status = crew_loads(crew, wrenches + 3 * k, load, row, &found);
        double *worth = row + crew->n;
        *worth++ = found.needed;
        *worth++ = found.shortfall;
        for (int c = 0; c < 9; c++)
            *worth++ = found.normals[c / 3][c % 3];
        for (int c = 0; c < 3; c++)
            *worth++ = found.price[c];
        work += crew->n + 16;
        if (status == 0 && work > ENOUGH) {
            work = 0;
            status = interrupted() ? -2 : 0;
        }
    }
    return status;
}

/* least_loads(generators, wrenches, load) -> bytes */
static PyObject *least_loads(PyObject *module, PyObject *args) {
    PyObject *generators, *wrenches, *result = NULL;
    Py_buffer robots, wanted;
    double load[3];
    (void)module;
    if (!PyArg_ParseTuple(args, "OO(ddd):least_loads", &generators, &wrenches, load, load + 1,
                          load + 2)
        || !are_finite(load) || get_doubles(generators, &robots, 3))
        return NULL;
    if (get_doubles(wrenches, &wanted, 3)) {
        PyBuffer_Release(&robots);
        return NULL;
    }
    Py_ssize_t n = rows_of(&robots, 3), many = rows_of(&wanted, 3);
    Crew crew = {0};
    int status = 0;
    if (many > PY_SSIZE_T_MAX / (Py_ssize_t)sizeof(double) / (n + LOADS))
        PyErr_NoMemory();
    else
        result = PyBytes_FromStringAndSize(NULL, many * (n + LOADS) * (Py_ssize_t)sizeof(double));
    if (result && (status = crew_room(&crew, robots.buf, n, interrupted)) == 0) {
        leave(n * many > 4096);
        status = fill_rows(&crew, wanted.buf, many, load, (double *)PyBytes_AsString(result));
        come_back();
    }
    crew_free(&crew);
    PyBuffer_Release(&robots);
    PyBuffer_Release(&wanted);
    if (status == -1)
        PyErr_NoMemory();
    if (status)
        Py_CLEAR(result);
    return result;
}

static PyMethodDef methods[] = {
    {"least_loads", least_loads, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyModuleDef_Slot slots[] = {{0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, .m_name = "loads", .m_slots = slots, .m_methods = methods,
};

PyMODINIT_FUNC PyInit_loads(void) { return PyModuleDef_Init(&definition); }
