"""Pages: what was measured, said in sentences that are checked, tabled and drawn.

What a page consists of is in `page`, how it is written in `writing`; it is left out here because
it draws.
"""
