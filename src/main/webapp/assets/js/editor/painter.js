import {AREA_COLOURS, TURNS, boxOnScreen, drawAreas, drawArrow} from '../floor/areas.js';
import {drawGridLines} from '../floor/grid-lines.js';
import {drawPlaces} from '../floor/places.js';
import {rowsOf} from '../floor/runs.js';
import {PLACE_KINDS, isPlace} from './drawing.js';

/** Draws what is edited: the drawing, what is selected, what the tool would do, the cursor. */
export class Painter {
  #walls = new WallPicture();

  /** @param cells indices of those that have changed; undefined: all may have */
  markChanged(cells) {
    this.#walls.markChanged(cells);
  }

  /**
   * @param scene {drawing, things, selected, shape, ends, cursor, marks, difference}
   */
  draw(context, viewport, colours, scene) {
    const {drawing} = scene;
    const {width, height, resolution, origin} = drawing.grid;
    const [left, top] = viewport.toScreen(origin.x, origin.y + height * resolution);
    const cell = resolution * viewport.scale;
    const frame = {left, top, cell, width, height};
    context.fillStyle = colours['map-free'];
    context.fillRect(left, top, width * cell, height * cell);
    if (cell >= 8) {
      drawGridLines(context, viewport, colours, frame);
    }
    drawAreas(context, viewport, colours, scene.things);
    context.imageSmoothingEnabled = false;
    const walls = this.#walls.picture(drawing, colours['map-wall']);
    context.drawImage(walls, left, top, width * cell, height * cell);
    context.strokeStyle = colours['map-wall'];
    context.lineWidth = 1;
    context.strokeRect(left - 0.5, top - 0.5, width * cell + 1, height * cell + 1);
    scene.difference?.draw(context, viewport, colours, frame);
    drawPlaces(context, viewport, colours, scene.things, resolution);
    this.#drawHeadings(context, viewport, colours, scene);
    this.#drawShape(context, colours, frame, scene.shape);
    this.#drawEnds(context, viewport, colours, scene);
    this.#drawSelection(context, viewport, colours, scene);
    this.#drawCursor(context, colours, frame, scene.cursor);
    drawMarks(context, viewport, colours, scene.marks);
  }

  /** How a robot stands at a place, and from where it comes. */
  #drawHeadings(context, viewport, colours, {drawing, things}) {
    const half = Math.max(6, 0.5 * drawing.grid.resolution * viewport.scale);
    for (const place of PLACE_KINDS.flatMap((kind) => things[kind])) {
      const [x, y] = viewport.toScreen(place.x, place.y);
      if (place.headingDegrees !== undefined && place.headingDegrees !== null) {
        drawNose(context, x, y, -place.headingDegrees * Math.PI / 180, half, colours['map-text']);
      }
      if (place.approach) {
        const angle = TURNS[place.approach];
        const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
        drawArrow(context, x - dx * half * 3, y - dy * half * 3, angle, half, colours['map-goal']);
      }
    }
  }

  #drawShape(context, colours, {left, top, cell}, shape) {
    if (!shape) {
      return;
    }
    context.globalAlpha = 0.6;
    context.fillStyle = colours[shape.isErasing ? 'state-error' : AREA_COLOURS[shape.kind] ?? 'map-wall'];
    for (const {column, row} of shape.cells ?? []) {
      context.fillRect(left + column * cell, top + row * cell, cell, cell);
    }
    if (shape.box) {
      const {left: from, right, top: first, bottom} = shape.box;
      context.globalAlpha = 0.35;
      context.fillRect(left + from * cell, top + first * cell, (right - from + 1) * cell, (bottom - first + 1) * cell);
    }
    context.globalAlpha = 1;
  }

  #drawEnds(context, viewport, colours, {drawing, ends}) {
    if (!ends) {
      return;
    }
    context.strokeStyle = colours['map-goal'];
    context.lineWidth = 2.5;
    context.setLineDash([7, 5]);
    context.beginPath();
    for (const end of ends) {
      const {x, y} = drawing.centre(end);
      context.lineTo(...viewport.toScreen(x, y));
    }
    context.stroke();
    context.setLineDash([]);
  }

  #drawSelection(context, viewport, colours, {drawing, selected}) {
    if (!selected) {
      return;
    }
    const {kind, thing} = selected;
    const half = drawing.grid.resolution / 2;
    const box = boxOnScreen(viewport, isPlace(kind) ? {x: thing.x - half, y: thing.y - half, width: 2 * half, height: 2 * half} : thing);
    context.strokeStyle = colours['state-driving'];
    context.lineWidth = 3;
    context.strokeRect(box.x - 3, box.y - 3, box.width + 6, box.height + 6);
  }

  #drawCursor(context, colours, {left, top, cell}, cursor) {
    if (cursor) {
      const size = Math.max(cell, 6);
      const [x, y] = [left + cursor.column * cell, top + cursor.row * cell];
      context.lineWidth = 4;
      context.strokeStyle = colours['map-halo'];
      context.strokeRect(x, y, size, size);
      context.lineWidth = 2;
      context.strokeStyle = colours['map-obstacle'];
      context.strokeRect(x, y, size, size);
    }
  }
}

/** The walls, one pixel a cell; after a stroke only its cells are drawn anew. */
class WallPicture {
  #canvas;
  #colour;
  #changed = new Set();

  markChanged(cells) {
    if (cells === undefined) {
      this.#canvas = undefined;
    } else {
      cells.forEach((cell) => this.#changed.add(cell));
    }
  }

  picture(drawing, colour) {
    const {width, height} = drawing.grid;
    if (!this.#canvas || this.#colour !== colour) {
      this.#canvas = new OffscreenCanvas(width, height);
      this.#colour = colour;
      const context = this.#canvas.getContext('2d');
      context.fillStyle = colour;
      for (const {column, row, count} of rowsOf(drawing.toJson().occupied, width)) {
        context.fillRect(column, row, count, 1);
      }
    } else {
      this.#update(drawing, width);
    }
    this.#changed.clear();
    return this.#canvas;
  }

  #update(drawing, width) {
    const context = this.#canvas.getContext('2d');
    context.fillStyle = this.#colour;
    for (const index of this.#changed) {
      const [x, y] = [index % width, Math.floor(index / width)];
      if (drawing.walls[index]) {
        context.fillRect(x, y, 1, 1);
      } else {
        context.clearRect(x, y, 1, 1);
      }
    }
  }
}

/** A triangle at the edge of a sign of that half width, which points outward. */
function drawNose(context, x, y, angle, half, colour) {
  context.save();
  context.translate(x, y);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(half * 1.1, -half * 0.55);
  context.lineTo(half * 1.9, 0);
  context.lineTo(half * 1.1, half * 0.55);
  context.fillStyle = colour;
  context.fill();
  context.restore();
}

function drawMarks(context, viewport, colours, marks) {
  context.strokeStyle = colours['state-error'];
  context.lineWidth = 3;
  for (const {x, y} of marks) {
    context.beginPath();
    context.arc(...viewport.toScreen(x, y), 14, 0, 2 * Math.PI);
    context.stroke();
  }
}
