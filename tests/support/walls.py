"""Walls for routes: L, U, a ceiling, and rooms."""

from skytender import geometry as ob


def walls(*boxes):
    return ob.table([ob.box(low, high) for low, high in boxes])


L_WALL = walls(([4, -6, -6], [4.3, 6, 0]), ([-4, 6, -6], [4.3, 6.3, 0]))


U_WALL = walls(([6, -4, -8], [6.3, 4, 0]), ([-10, -4.3, -8], [6.3, -4, 0]), ([-10, 4, -8], [6.3, 4.3, 0]))


CEILING = walls(([6, -4, -8], [6.3, 4, 0]), ([-10, -4.3, -8], [6.3, -4, 0]), ([-10, 4, -8], [6.3, 4.3, 0]),
                ([-10, -4.3, -8.3], [6.3, 4.3, -8]))  # fmt: skip


def room(low, high, thick=0.3):
    (n0, e0, d0), (n1, e1, d1) = low, high
    return walls(
        ([n0 - thick, e0, d0], [n0, e1, d1]), ([n1, e0, d0], [n1 + thick, e1, d1]),
        ([n0, e0 - thick, d0], [n1, e0, d1]), ([n0, e1, d0], [n1, e1 + thick, d1]),
        ([n0 - thick, e0 - thick, d0 - thick], [n1 + thick, e1 + thick, d0]),
    )  # fmt: skip
