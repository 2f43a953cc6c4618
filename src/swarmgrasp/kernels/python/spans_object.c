/* Searches over spans as Python objects. Checked are widths, finite numbers, counts and who uses a search;
 * the objects keep the arrays and the sets that they were given. */
#include <string.h>

#include "spans_object.h"
#include "sets_object.h"
#include "state.h"

typedef struct {
    PyObject_HEAD
    SpanSearch search;
    Py_buffer pieces;
    PyObject *sets;
    int is_busy;
} SpansObject;

static void spans_dealloc(PyObject *object) {
    SpansObject *self = (SpansObject *)object;
    PyTypeObject *type = Py_TYPE(object);
    spans_end(&self->search);
    if (self->pieces.obj)
        PyBuffer_Release(&self->pieces);
    Py_XDECREF(self->sets);
    freefunc release = (freefunc)PyType_GetSlot(type, Py_tp_free);
    release(object);
    Py_DECREF(type);
}

static PyObject *spans_new(PyTypeObject *type, PyObject *args, PyObject *kwargs) {
    PyObject *given, *arrays[2];
    double units = WORK, all = 0.0;
    if (kwargs && PyDict_Size(kwargs) > 0) {
        PyErr_SetString(PyExc_TypeError, "Spans takes no keyword arguments");
        return NULL;
    }
    PyObject *ends;
    if (!PyArg_ParseTuple(args, "OOOO|d:Spans", &given, &ends, arrays, arrays + 1, &units))
        return NULL;
    const State *state = PyType_GetModuleState(type);
    const Sets *sets = sets_of(state->sets_type, given);
    if (!sets)
        return NULL;
    allocfunc make = (allocfunc)PyType_GetSlot(type, Py_tp_alloc);
    SpansObject *self = (SpansObject *)make(type, 0);
    if (!self)
        return NULL;
    Py_buffer elements = {0}, counts = {0};
    Status status = SOLVED;
    self->sets = Py_NewRef(given);
    int failed = get_doubles(ends, &self->pieces, 4) || get_doubles(arrays[0], &elements, ELEMENT)
                 || get_doubles(arrays[1], &counts, 1);
    int many = failed ? 0 : rows_of(&self->pieces, 4);
    const double *count = counts.buf;
    for (int k = 0; !failed && k < many && k < rows_of(&counts, 1); k++)
        all += count[k] >= 1.0 && count[k] == (double)(int)count[k] ? count[k] : NAN;
    if (!failed && (many == 0 || rows_of(&counts, 1) != many || all != rows_of(&elements, ELEMENT))) {
        PyErr_SetString(PyExc_ValueError, "pieces, and elements for each of them, are wanted");
        failed = 1;
    }
    if (!failed) {
        leave(1);
        status = spans_begin(&self->search, sets, self->pieces.buf, many, elements.buf, count, units,
                             interrupted);
        come_back();
    }
    if (elements.obj)
        PyBuffer_Release(&elements);
    if (counts.obj)
        PyBuffer_Release(&counts);
    if (!failed && !is_raised(status))
        return (PyObject *)self;
    Py_DECREF(self);
    return NULL;
}

/* Take a search into use: a signal's handler, or another thread, may call while it runs. */
static SpanSearch *take(PyObject *object) {
    SpansObject *self = (SpansObject *)object;
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
    ((SpansObject *)object)->is_busy = 0;
}

static void write_span(const Span *span, double *row) {
    double head[] = {span->piece, span->from, span->to, span->bound, span->kind};
    memcpy(row, head, sizeof head);
    memset(row + 5, 0, 8 * sizeof *row);
    for (int k = 0; k < span->terms; k++) {
        memcpy(row + 5 + 4 * k, span->normal[k], sizeof span->normal[k]);
        row[8 + 4 * k] = span->weight[k];
    }
}

/* solve(gap, chosen, asks) -> (solved, best, spans) */
static PyObject *spans_solve_method(PyObject *object, PyObject *args) {
    SpansObject *self = (SpansObject *)object;
    const char *chosen = NULL;
    Py_ssize_t chosen_size = self->search.many;
    int asks = SPAN_ASKS;
    double gap;
    Stand best;
    if (!PyArg_ParseTuple(args, "dz#|i:solve", &gap, &chosen, &chosen_size, &asks))
        return NULL;
    if (chosen && chosen_size != self->search.many) {
        PyErr_Format(PyExc_ValueError, "there are %d pieces", self->search.many);
        return NULL;
    }
    SpanSearch *s = take(object);
    if (!s)
        return NULL;
    Status status = spans_solve(s, chosen, gap, asks, &best);
    give_back(object);
    if (is_raised(status))
        return NULL;
    PyObject *spans = PyBytes_FromStringAndSize(NULL, SPAN_ROW * s->closes * (Py_ssize_t)sizeof(double));
    if (!spans)
        return NULL;
    double *row = (double *)PyBytes_AsString(spans);
    for (int k = 0; k < s->closes; k++)
        write_span(s->closed + k, row + (Py_ssize_t)SPAN_ROW * k);
    return Py_BuildValue("(O(did)N)", status == SOLVED ? Py_True : Py_False, best.quality,
                         best.piece, best.share, spans);
}

/* quality_at(piece, share) -> (quality, normal) */
static PyObject *spans_quality_method(PyObject *object, PyObject *args) {
    int piece;
    double share, quality, n[3];
    if (!PyArg_ParseTuple(args, "id:quality_at", &piece, &share))
        return NULL;
    if (piece < 0 || piece >= ((SpansObject *)object)->search.many || !(share >= 0.0 && share <= 1.0)) {
        PyErr_SetString(PyExc_ValueError, "a piece and a share of the way are wanted");
        return NULL;
    }
    SpanSearch *s = take(object);
    if (!s)
        return NULL;
    Status status = spans_quality(s, piece, share, &quality, n);
    give_back(object);
    return is_raised(status) ? NULL : Py_BuildValue("d(ddd)", quality, n[0], n[1], n[2]);
}

/* normals() -> bytes: those met */
static PyObject *spans_normals_method(PyObject *object, PyObject *ignored) {
    const SpanSearch *s = take(object);
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

static PyObject *spans_base_get(PyObject *object, void *ignored) {
    const SpanSearch *s = &((SpansObject *)object)->search;
    (void)ignored;
    return Py_BuildValue("d(ddd)", s->quality, s->weakest[0], s->weakest[1], s->weakest[2]);
}

static PyObject *spans_size_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SpansObject *)object)->search.size);
}

static PyObject *spans_left_get(PyObject *object, void *ignored) {
    (void)ignored;
    return PyFloat_FromDouble(((SpansObject *)object)->search.work.left);
}

static PyMethodDef methods[] = {
    {"solve", spans_solve_method, METH_VARARGS, NULL},
    {"quality_at", spans_quality_method, METH_VARARGS, NULL},
    {"normals", spans_normals_method, METH_NOARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static PyGetSetDef getset[] = {
    {"base", spans_base_get, NULL, NULL, NULL},
    {"size", spans_size_get, NULL, NULL, NULL},
    {"left", spans_left_get, NULL, NULL, NULL},
    {NULL, NULL, NULL, NULL, NULL},
};

static PyType_Slot type_slots[] = {
    {Py_tp_dealloc, spans_dealloc}, {Py_tp_new, spans_new}, {Py_tp_methods, methods},
    {Py_tp_getset, getset},         {0, NULL},
};

static PyType_Spec type_spec = {
    .name = "swarmgrasp.kernels.core.Spans",
    .basicsize = sizeof(SpansObject),
    .flags = Py_TPFLAGS_DEFAULT,
    .slots = type_slots,
};

PyObject *make_spans_type(PyObject *module) {
    return PyType_FromModuleAndSpec(module, &type_spec, NULL);
}
