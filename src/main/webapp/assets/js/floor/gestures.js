const TAP = 6; // pixels that a pointer may move during a tap
const STEP = 60; // pixels that an arrow key moves

/**
 * Moves a viewport by mouse, wheel, fingers and keys.
 *
 * @param onChange called after each movement
 * @param onTap called with the canvas point of a click that moved nothing
 * @param stroke where one pointer draws instead of moving the viewport: its start, move and end take canvas points,
 *     cancel nothing; start answers whether it draws
 */
export function listenForGestures(canvas, viewport, onChange, onTap = () => {}, stroke = undefined) {
  const pointers = new Map();
  let moved = 0;
  let isDrawing = false;

  const position = (event) => [event.offsetX, event.offsetY];
  const distance = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, position(event));
    moved = pointers.size > 1 ? Infinity : 0;
    if (isDrawing) {
      isDrawing = false;
      stroke.cancel(); // two fingers move the viewport
    } else if (stroke && pointers.size === 1 && event.button === 0) {
      isDrawing = stroke.start(...position(event));
    }
  });

  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) {
      return;
    }
    const now = position(event);
    if (isDrawing) {
      pointers.set(event.pointerId, now);
      stroke.move(...now);
      return;
    }
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    moved += Math.hypot(dx, dy);
    if (pointers.size === 1 && moved <= TAP) {
      return;
    }
    const startDistance = pointers.size === 2 ? distance() : 0;
    pointers.set(event.pointerId, now);
    if (startDistance > 0) {
      const [a, b] = [...pointers.values()];
      viewport.zoom(distance() / startDistance, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    }
    viewport.pan(dx / pointers.size, dy / pointers.size);
    onChange();
  });

  const end = (event) => {
    const isKnown = pointers.delete(event.pointerId);
    if (isDrawing) {
      isDrawing = false;
      if (event.type === 'pointerup') {
        stroke.end(...position(event));
      } else {
        stroke.cancel();
      }
    } else if (isKnown && event.type === 'pointerup' && moved <= TAP) {
      onTap(...position(event));
    }
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);

  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      viewport.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), ...position(event));
      onChange();
    },
    {passive: false},
  );

  const keys = {
    ArrowLeft: () => viewport.pan(STEP, 0),
    ArrowRight: () => viewport.pan(-STEP, 0),
    ArrowUp: () => viewport.pan(0, STEP),
    ArrowDown: () => viewport.pan(0, -STEP),
    '+': () => viewport.zoom(1.3),
    '=': () => viewport.zoom(1.3),
    '-': () => viewport.zoom(1 / 1.3),
    0: () => viewport.fit(),
  };
  canvas.addEventListener('keydown', (event) => {
    const move = event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
    if (move) {
      event.preventDefault();
      move();
      onChange();
    }
  });
}
