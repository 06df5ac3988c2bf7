// Put into a page before it opens: notes how far each text on the live map moves, and films it.
{
  const PERIOD = 100; // milliseconds between two pictures
  const CHUNK = 1_000; // milliseconds of film that are kept at once

  const places = new Map();

  // what stands still is drawn into a picture once, which is copied then
  for (const {prototype} of [CanvasRenderingContext2D, OffscreenCanvasRenderingContext2D]) {
    const {fillText} = prototype;
    prototype.fillText = function (text, x, y, ...more) {
      const words = text.replace(/[\u2068\u2069]/g, ''); // marks of direction
      const {travelled, ...before} = places.get(words) ?? {x, y, travelled: 0};
      places.set(words, {x, y, travelled: travelled + Math.hypot(x - before.x, y - before.y)});
      return fillText.call(this, text, x, y, ...more);
    };
  }

  /** Pixels that a text has gone since the film began. */
  window.wayOf = (text) => {
    if (!places.has(text)) {
      throw new Error(`The map never showed "${text}".`);
    }
    return places.get(text).travelled;
  };

  const base64 = (blob) =>
    new Promise((resolve) => {
      const reader = new FileReader();
      reader.addEventListener('load', () => resolve(reader.result.replace(/.*,/, '')));
      reader.readAsDataURL(blob);
    });

  /** Notes from here on how far texts go; with a map it is filmed. */
  window.beginFilm = (map) => {
    for (const place of places.values()) {
      place.travelled = 0;
    }
    window.endFilm = () => {};
    if (map === null) {
      return;
    }
    const picture = document.createElement('canvas');
    picture.width = map.width;
    picture.height = map.height;
    const context = picture.getContext('2d');
    context.fillStyle = getComputedStyle(document.documentElement).backgroundColor;
    const draw = () => {
      context.fillRect(0, 0, picture.width, picture.height);
      context.drawImage(map, 0, 0);
    };
    draw();
    setInterval(draw, PERIOD);

    let kept = Promise.resolve();
    const recorder = new MediaRecorder(picture.captureStream(), {mimeType: 'video/webm'});
    recorder.addEventListener('dataavailable', ({data}) => {
      kept = kept.then(async () => window.keepFilm(await base64(data)));
    });
    window.endFilm = () =>
      new Promise((resolve) => {
        recorder.addEventListener('stop', () => resolve(kept));
        recorder.stop();
      });
    recorder.start(CHUNK);
  };
}
