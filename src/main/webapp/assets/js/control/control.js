import {headingDegrees} from '../shared/angles.js';
import {showCameras} from '../shared/cameras.js';
import {setText} from '../shared/elements.js';
import {subscribe} from '../shared/event-stream.js';
import {updateLiveRegions} from '../shared/live-regions.js';
import {locale} from '../shared/locale.js';
import {send} from '../shared/server.js';
import {text} from '../shared/texts.js';
import {ArmPanel} from './arm-panel.js';
import {ControlMap} from './control-map.js';
import {Gauge} from './gauge.js';
import {Hand} from './hand.js';
import {LiveChart} from './live-chart.js';
import {Ranges} from './ranges.js';

const $ = (selector) => document.querySelector(selector);
const MILLIMETRES = 1_000; // in a metre
const DEGREES = 180 / Math.PI; // in a radian
const metres = new Intl.NumberFormat(locale, {minimumFractionDigits: 2, maximumFractionDigits: 2});
const whole = new Intl.NumberFormat(locale, {maximumFractionDigits: 0});

/** What one robot does at this moment, and the buttons that start, stop and drive it. */
class ControlPage {
  #data = $('#control').dataset;
  #map = new ControlMap($('#floor'), this.#data.robot);
  #left = new Gauge($('#gauge-left'));
  #right = new Gauge($('#gauge-right'));
  #ranges = new Ranges(this.#data.robot, this.#data.readings === 'true');
  #arm = new ArmPanel($('#arm'));
  #crossTrack = new LiveChart('crossTrack', 'control.unit.mm', 10, 0);
  #heading = new LiveChart('heading', 'control.unit.degrees', 5, 1);
  #hand = $('#hand') ? new Hand($('#hand'), this.#data) : undefined;

  start() {
    this.#listenTo($('#stop'), 'hold');
    this.#listenTo($('#start'), 'resume');
    subscribe((snapshot) => this.#update(snapshot), (connection) => this.#showConnection(connection));
  }

  /** A form that stays on the page, and says so where it is refused. */
  #listenTo(form, command) {
    form?.addEventListener('submit', async (event) => {
      event.preventDefault();
      const {status, body} = await send('POST', `api/v1/robots/${encodeURIComponent(this.#data.robot)}/${command}`);
      const refused = $('#refused');
      refused.hidden = status === 200;
      setText(refused, status === 200 ? '' : (body?.detail ?? text('control.failed')));
    });
  }

  #update(snapshot) {
    updateLiveRegions(snapshot);
    const robot = snapshot.robots.find(({name}) => name === this.#data.robot);
    if (!robot) {
      return;
    }
    const now = performance.now();
    const version = snapshot.floors.find(({floor}) => floor === robot.floor)?.map;
    this.#map.update(snapshot.robots, robot, version);
    this.#showPose(robot.pose);
    this.#showSpeeds(robot);
    this.#ranges.update(robot);
    this.#arm.update(robot);
    this.#crossTrack.add(robot.deviation ? MILLIMETRES * robot.deviation.crossTrack : undefined, now);
    this.#heading.add(robot.deviation ? DEGREES * robot.deviation.heading : undefined, now);
    this.#hand?.update(robot);
    const start = $('#start button');
    if (start) {
      start.disabled = !robot.held;
    }
  }

  #showPose(pose) {
    const shown = pose
      ? `${metres.format(pose.x)}, ${metres.format(pose.y)} · ${whole.format(headingDegrees(pose.theta))}°`
      : '–';
    setText($('#pose'), shown);
  }

  /** Of its wheels where it has two and says how far they are apart, else of its body. */
  #showSpeeds({twist, track, kind}) {
    const isOfWheels = kind === 'differential' && track > 0;
    setText($('#speeds-note'), text(isOfWheels ? 'control.speeds.wheels' : 'control.speeds.body'));
    if (isOfWheels) {
      // vL = v - L w / 2, vR = v + L w / 2
      const of = (side) => twist ? twist.v + (side * track * twist.w) / 2 : undefined;
      this.#left.show(text('control.wheel.left'), of(-1), 0.52, 'control.unit.speed');
      this.#right.show(text('control.wheel.right'), of(1), 0.52, 'control.unit.speed');
    } else {
      this.#left.show(text('control.speed.v'), twist?.v, 0.5, 'control.unit.speed');
      this.#right.show(text('control.speed.w'), twist?.w, 1.5, 'control.unit.turn');
    }
  }

  #showConnection(connection) {
    const banner = $('#connection');
    banner.hidden = connection === 'live';
    if (connection !== 'live') {
      setText(banner, text(connection === 'loggedOut' ? 'map.loggedOut' : 'control.disconnected'));
    }
  }
}

new ControlPage().start();
showCameras();
