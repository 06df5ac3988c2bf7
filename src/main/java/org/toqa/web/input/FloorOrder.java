package org.toqa.web.input;

import org.toqa.grid.FloorDrawing;

/** A floor that is to be added. */
public record FloorOrder(String name, FloorDrawing drawing) {}
