import {setText} from './elements.js';
import {address} from './server.js';
import {text} from './texts.js';

/** Milliseconds between two pictures of a camera. */
const PERIOD = 400;

/** The same after one that did not come. */
const RETRY_PERIOD = 3_000;

/** A figure with the picture of a camera, or the sentence that says why there is none. */
class CameraFigure {
  #figure;
  #image;
  #says;
  #path;

  constructor(figure) {
    this.#figure = figure;
    this.#image = figure.querySelector('img');
    this.#says = figure.querySelector('p');
    this.#path = `api/v1/cameras/${figure.dataset.camera}/picture`;
  }

  async start() {
    for (;;) {
      // Nobody looks at a picture that is hidden, or at a page that is.
      const isSeen = !this.#figure.hidden && !document.hidden;
      const isShown = isSeen ? await this.#ask() : true;
      await new Promise((resolve) => setTimeout(resolve, isShown ? PERIOD : RETRY_PERIOD));
    }
  }

  /** Whether there is a picture. It is no use of the session: pages ask while nobody sits before them. */
  async #ask() {
    let sentence = text('camera.failed');
    try {
      const answer = await fetch(address(this.#path), {headers: {'x-toqa-background': 'yes'}});
      if (answer.ok) {
        this.#image.src = await dataAddress(await answer.blob());
        this.#image.hidden = false;
        this.#says.hidden = true;
        return true;
      }
      sentence = (await answer.json()).detail ?? sentence;
    } catch {
      // neither the server nor a problem of its: the sentence above
    }
    this.#image.hidden = true;
    this.#says.hidden = false;
    setText(this.#says, sentence);
    return false;
  }
}

/** The bytes as an address, since the pages may show none of blobs. */
function dataAddress(blob) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener('load', () => resolve(reader.result));
    reader.addEventListener('error', () => reject(reader.error));
    reader.readAsDataURL(blob);
  });
}

/** Shows what the cameras of the page see, from now on. */
export function showCameras() {
  for (const figure of document.querySelectorAll('[data-camera]')) {
    new CameraFigure(figure).start();
  }
}

/** Of the cameras that watch floors those of that floor are shown; a section without any is hidden. */
export function showCamerasOf(floor, section) {
  for (const figure of section.querySelectorAll('[data-camera]')) {
    figure.hidden = figure.dataset.floor !== floor;
  }
  section.hidden = !section.querySelector('[data-camera]:not([hidden])');
}
