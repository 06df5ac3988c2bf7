import {armPoints} from '../map/arm.js';
import {setText} from '../shared/elements.js';
import {locale} from '../shared/locale.js';
import {text} from '../shared/texts.js';

const DEGREES = 180 / Math.PI; // in a radian
const HALF = 100; // of the picture, in its units
const NOWHERE = {x: 0, y: 0, theta: 0};

const two = new Intl.NumberFormat(locale, {minimumFractionDigits: 2, maximumFractionDigits: 2});
const whole = new Intl.NumberFormat(locale, {maximumFractionDigits: 0, signDisplay: 'negative'});

/** A robot's arm from above, the robot facing upward, with what its joints and its hand tell. */
export class ArmPanel {
  #panel;
  #pictured; // the arm and the robot's size that the fixed parts were drawn for

  constructor(panel) {
    this.#panel = panel;
  }

  /** Hidden while no arm is known. */
  update({arm, footprint}) {
    this.#panel.hidden = !arm;
    if (!arm) {
      return;
    }
    const points = armPoints(arm, NOWHERE);
    this.#draw(arm, footprint, points);
    const joints = arm.joints;
    this.#tell('shoulder', joints && text('control.unit.degrees', whole.format(joints.shoulder * DEGREES)));
    this.#tell('elbow', joints && text('control.unit.degrees', whole.format(joints.elbow * DEGREES)));
    this.#tell('hand', points && text('control.arm.at', two.format(points[2][0]), two.format(points[2][1])));
    this.#tell('load', !joints ? undefined : arm.load === null || arm.load === undefined
      ? text('control.arm.empty')
      : text('control.unit.kilograms', two.format(arm.load)));
    this.#tell('step', joints && text(`control.arm.step.${arm.step ?? 'NONE'}`));
  }

  #tell(what, value) {
    setText(this.#panel.querySelector(`[data-arm="${what}"]`), value ?? '–');
  }

  #draw(arm, footprint, points) {
    const {base, upperLink, foreLink} = arm;
    const reach = upperLink + foreLink;
    const farthest = Math.max(footprint / 2, Math.hypot(base.x, base.y) + reach);
    const scale = (0.95 * HALF) / farthest;
    const place = ([x, y]) => [-y * scale, -x * scale].map((value) => Number(value.toFixed(2)));
    const shape = JSON.stringify([base, upperLink, foreLink, footprint]);
    if (shape !== this.#pictured) {
      this.#pictured = shape;
      const [x, y] = place([base.x, base.y]);
      this.#circle('.body', 0, 0, (footprint / 2) * scale);
      this.#circle('.reach', x, y, reach * scale);
      this.#circle('.near', x, y, Math.abs(upperLink - foreLink) * scale);
      const nose = (footprint / 2) * scale;
      this.#set('.nose', 'd', `M${-nose / 4},${-nose} L0,${-1.3 * nose} L${nose / 4},${-nose} Z`);
    }
    const at = points?.map(place);
    this.#set('.links', 'points', at?.map((point) => point.join()).join(' ') ?? '');
    for (const [index, part] of ['.shoulder', '.elbow', '.hand'].entries()) {
      const [x, y] = at?.[index] ?? [0, 0];
      this.#circle(part, x, y, at ? 4 : 0);
    }
    this.#panel.querySelector('.hand').classList.toggle('full', Boolean(arm.load));
  }

  #circle(part, x, y, radius) {
    this.#set(part, 'cx', x);
    this.#set(part, 'cy', y);
    this.#set(part, 'r', radius);
  }

  #set(part, name, value) {
    this.#panel.querySelector(`svg ${part}`).setAttribute(name, value);
  }
}
