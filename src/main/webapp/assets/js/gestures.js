const TAP = 6; // pixels that a finger or a mouse may slip in a tap
const STEP = 60; // pixels that an arrow key moves

/**
 * Moves a viewport by mouse, wheel, fingers and keys.
 *
 * @param onChange called after each movement
 * @param onTap called with the canvas point of a click that moved nothing
 */
export function listenForGestures(canvas, viewport, onChange, onTap = () => {}) {
  const fingers = new Map();
  let travelled = 0;

  const at = (event) => [event.offsetX, event.offsetY];
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };

  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, at(event));
    travelled = fingers.size > 1 ? Infinity : 0;
  });

  canvas.addEventListener('pointermove', (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) {
      return;
    }
    const now = at(event);
    const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
    travelled += Math.hypot(dx, dy);
    if (fingers.size === 1 && travelled <= TAP) {
      return;
    }
    const apart = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, now);
    if (apart > 0) {
      const [a, b] = [...fingers.values()];
      viewport.zoom(spread() / apart, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    }
    viewport.pan(dx / fingers.size, dy / fingers.size);
    onChange();
  });

  const lift = (event) => {
    if (fingers.delete(event.pointerId) && event.type === 'pointerup' && travelled <= TAP) {
      onTap(...at(event));
    }
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);

  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      viewport.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), ...at(event));
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
    const move = event.ctrlKey || event.metaKey || event.altKey ? null : keys[event.key];
    if (move) {
      event.preventDefault();
      move();
      onChange();
    }
  });
}
