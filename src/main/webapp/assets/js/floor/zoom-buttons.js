/** The buttons beside a floor's canvas that zoom it. */
export function listenForZoomButtons(canvas) {
  const {viewport} = canvas;
  const actions = {
    '#zoom-in': () => viewport.zoom(1.4),
    '#zoom-out': () => viewport.zoom(1 / 1.4),
    '#zoom-fit': () => viewport.fit(),
  };
  for (const [button, zoom] of Object.entries(actions)) {
    document.querySelector(button).addEventListener('click', () => {
      zoom();
      canvas.requestFrame();
    });
  }
}
