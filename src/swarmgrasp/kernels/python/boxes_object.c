/* Searches over boxes as Python objects. Checked are widths, finite numbers, forces and who uses a search;
 * the objects keep the arrays and the sets that they were given. */
#include <string.h>

#include "boxes_object.h"
#include "sets_object.h"
#include "state.h"

typedef struct {
    PyObject_HEAD
    BoxSearch search;
    Py_buffer pieces;
    PyObject *sets;
    int is_busy;
} BoxesObject;

static void boxes_dealloc(PyObject *object) {
    BoxesObject *self = (BoxesObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    boxes_end(&self->search);
    if (self->pieces.obj)
        PyBuffer_Release(&self->pieces);
    Py_XDECREF(self->sets);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

static PyObject *boxes_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *given, *pieces;
    double limit, reverse, units = WORK;
    if (kwargs && PyDict_Size(kwargs) > 0) {
        PyErr_SetString(PyExc_TypeError, "Boxes takes no keyword arguments");
        return NULL;
    }
    if (!PyArg_ParseTuple(args, "OOdd|d:Boxes", &given, &pieces, &limit, &reverse, &units))
        return NULL;
    if (!(limit > 0.0 && limit < INFINITY && reverse >= 0.0 && reverse < INFINITY)) {
        PyErr_SetString(PyExc_ValueError, "a positive limit and a reverse limit are wanted");
        return NULL;
    }
    const State *state = PyType_GetModuleState(type);
    const Sets *sets = sets_of(state->sets_type, given);
    if (!sets)
        return NULL;
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    BoxesObject *self = (BoxesObject *)make(type, 0);
    if (!self)
        return NULL;
    self->sets = Py_NewRef(given);
    if (get_doubles(pieces, &self->pieces, PIECE))
        goto failed;
    if (self->pieces.len == 0) {
        PyErr_SetString(PyExc_ValueError, "there are no pieces");
        goto failed;
    }
    leave(1);
    Status status = boxes_begin(&self->search, sets, self->pieces.buf,
                                rows_of(&self->pieces, PIECE), limit, reverse, units, interrupted);
    come_back();
    if (!is_raised(status))
        return (PyObject *)self;
failed:
    Py_DECREF(self);
    return NULL;
}

/* Take a search into use: a signal's handler, or another thread, may call while it runs. */
static BoxSearch *take(PyObject *object) {
    BoxesObject *self = (BoxesObject *)object;
    if (self->is_busy) {
        PyErr_SetString(PyExc_RuntimeError, "the search is in use");
        return NULL;
    }
    self->is_busy = 1;
    leave(1);
    return &self->search;
}

static void give_back(PyObject *object) {
    come_back();
    ((BoxesObject *)object)->is_busy = 0;
}

static void write_box(const Box *box, double *row) {
    double head[] = {box->piece, box->from, box->to, box->lo, box->hi, box->bound};
    memcpy(row, head, sizeof head);
    memset(row + 6, 0, TERM_ROW * CORNERS * sizeof *row);
    for (int k = 0; k < box->terms; k++) {
        double *at = row + 6 + TERM_ROW * k;
        at[0] = box->term[k].kind;
        memcpy(at + 1, box->term[k].vector, sizeof box->term[k].vector);
        at[4] = box->term[k].weight;
        for (int l = 0; l < LOST; l++)
            at[5 + l] = box->term[k].lost[l];
    }
}

/* solve(gap, chosen, asks) -> (solved, best, boxes) */
static PyObject *boxes_solve_method(PyObject *object, PyObject *args) {
    BoxesObject *self = (BoxesObject *)object;
    const char *chosen = NULL;
    Py_ssize_t chosen_size = self->search.many;
    int asks = ASKS;
    double gap;
    Place best;
    if (!PyArg_ParseTuple(args, "dz#|i:solve", &gap, &chosen, &chosen_size, &asks))
        return NULL;
    if (chosen && chosen_size != self->search.many) {
        PyErr_Format(PyExc_ValueError, "there are %d pieces", self->search.many);
        return NULL;
    }
    BoxSearch *s = take(object);
    if (!s)
        return NULL;
    Status status = boxes_solve(s, chosen, gap, asks, &best);
    give_back(object);
    if (is_raised(status))
        return NULL;
    PyObject *boxes = PyBytes_FromStringAndSize(NULL, BOX_ROW * s->closes * (Py_ssize_t)sizeof(double));
    if (!boxes)
        return NULL;
    double *row = (double *)PyBytes_AsString(boxes);
    for (int k = 0; k < s->closes; k++)
        write_box(s->closed + k, row + (Py_ssize_t)BOX_ROW * k);
    return Py_BuildValue("(O(didd)N)", status == SOLVED ? Py_True : Py_False, best.quality,
                         best.piece, best.share, best.direction, boxes);
}

/* qualities_at(robots) -> bytes: the quality and its normal with each, (x, y, direction) */
static PyObject *boxes_qualities_method(PyObject *object, PyObject *robots) {
    Py_buffer view;
    if (get_doubles(robots, &view, 3))
        return NULL;
    int count = rows_of(&view, 3);
    Status status = SOLVED;
    PyObject *result = PyBytes_FromStringAndSize(NULL, 4 * count * (Py_ssize_t)sizeof(double));
    double *found = result ? (double *)PyBytes_AsString(result) : NULL;
    BoxSearch *s = result ? take(object) : NULL;
    if (s) {
        for (int k = 0; k < count && !is_fault(status); k++, found += 4) {
            const double *robot = (const double *)view.buf + 3 * (Py_ssize_t)k;
            status = boxes_quality(s, robot, robot[2], EXACT, found, found + 1);
            if (status == OUT_OF_BUDGET)
                *found = 0.0;
        }
        give_back(object);
    }
    PyBuffer_Release(&view);
    if (!s || is_raised(status))
        Py_CLEAR(result);
    return result;
}

/* normals() -> bytes: those met */
static PyObject *boxes_normals_method(PyObject *object, PyObject *ignored) {
    const BoxSearch *s = take(object);
    (void)ignored;
    if (!s)
        return NULL;
    give_back(object); /* nothing below lets others run */
    PyObject *result = PyBytes_FromStringAndSize(NULL, 3 * s->count * (Py_ssize_t)sizeof(double));
    double *out = result ? (double *)PyBytes_AsString(result) : NULL;
    for (int k = 0; result && k < s->count; k++)
        memcpy(out + 3 * k, s->pool[k].normal, sizeof s->pool[k].normal);
    return result;
}

static PyObject *boxes_base_get(PyObject *object, void *ignored) {
    const BoxSearch *s = &((BoxesObject *)object)->search;
    (void)ignored;
    return Py_BuildValue("d(ddd)", s->quality, s->weakest[0], s->weakest[1], s->weakest[2]);
}

static PyObject *boxes_size_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((BoxesObject *)object)->search.size);
}

static PyObject *boxes_left_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((BoxesObject *)object)->search.work.left);
}

static PyMethodDef methods[] = {
    {"solve", boxes_solve_method, METH_VARARGS, NULL},
    {"qualities_at", boxes_qualities_method, METH_O, NULL},
    {"normals", boxes_normals_method, METH_NOARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyGetSetDef getset[] = {
    {"base", boxes_base_get, NULL, NULL, NULL},
    {"size", boxes_size_get, NULL, NULL, NULL},
    {"left", boxes_left_get, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot type_slots[] = {
    {Py_tp_dealloc, boxes_dealloc}, {Py_tp_new, boxes_new}, {Py_tp_methods, methods},
    {Py_tp_getset, getset},         {0, NULL},
};

static PyType_Spec type_spec = {
    .name = "swarmgrasp.kernels.core.Boxes",
    .basicsize = sizeof(BoxesObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = type_slots,
};

PyObject *make_boxes_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &type_spec, NULL);
}
