import {FloorCanvas} from '../floor/floor-canvas.js';
import {Floor} from '../floor/floor.js';
import {listenForZoomButtons} from '../floor/zoom-buttons.js';
import {updateReplayLists} from '../replay/replay-lists.js';
import {Replay} from '../replay/replay.js';
import {showCameras, showCamerasOf} from '../shared/cameras.js';
import {subscribe} from '../shared/event-stream.js';
import {updateLiveRegions} from '../shared/live-regions.js';
import {updateAttentionList} from './attention-list.js';
import {ConnectionStatus} from './connection-status.js';
import {FleetState} from './fleet-state.js';
import {FloorActions} from './floor-actions.js';
import {Following} from './following.js';
import {drawAges, drawBlockedCells, drawStandstills} from './hazards.js';
import {updateLiveLists} from './live-lists.js';
import {Measuring} from './measuring.js';
import {PoseInterpolator} from './pose-interpolator.js';
import {drawBoxes, drawLeftLoads, drawRobots, drawTasks, replayedRobot} from './robots.js';
import {StateFilter} from './state-filter.js';
import {Switch} from './switch.js';
import {drawZones} from './zones.js';

const MINUTE = 60_000; // milliseconds
const SMALLEST_FOOTPRINT = 0.255; // metres, the diameter of a robot of which nothing else is known

const $ = (selector) => document.querySelector(selector);

/** The map page: a floor with its robots and tasks, live or as a replay, and the lists beside it. */
class MapPage {
  #floor; // undefined until it is loaded
  #shownAt; // milliseconds since 1970, of the map of a replay; undefined: it is the one in force
  #isLoading = false;
  #shownRobots = []; // of the floor; faint where the filter lets them not through
  #hasSnapshot = false;
  #state = new FleetState();
  #interpolator = new PoseInterpolator();
  #replay = new Replay(() => this.#state.time, () => this.#floor.name, () => this.#showMode());
  #status = new ConnectionStatus(() => this.#replay.isOpen);
  #filter = new StateFilter($('#counts'), () => this.#showLive());
  #canvas = new FloorCanvas($('#map'), this.#draw.bind(this), this.#tap.bind(this));
  #following = new Following($('#following'), this.#canvas, this.#state, (name) => this.#poseOf(name, performance.now()));

  #measuring = new Measuring($('#measuring'), $('#measure'), this.#canvas);
  #actions = new FloorActions($('#live-lists'));
  #zones = new Switch($('#zones'), this.#canvas);
  #margins = new Switch($('#margins'), this.#canvas);

  async start() {
    listenForZoomButtons(this.#canvas);
    const select = $('#floor');
    select?.addEventListener('change', () => this.#showFloor(select.value));
    const wanted = new URLSearchParams(location.search).get('floor');
    if (select && [...select.options].some(({value}) => value === wanted)) {
      select.value = wanted;
    }
    await this.#showFloor(select?.value);
    subscribe(this.#update.bind(this), (connection) => this.#status.change(connection));
  }

  #update(snapshot) {
    const now = performance.now();
    this.#state.update(snapshot);
    updateLiveRegions(snapshot);
    this.#status.markUpdated(now);
    this.#interpolator.update(this.#state.robots, now);
    if (!this.#hasSnapshot) {
      this.#hasSnapshot = true;
      this.#followRequested();
    }
    $('#replay-open').disabled = !this.#floor;
    updateAttentionList($('#attention'), this.#state);
    if (!this.#replay.isOpen) {
      this.#showLive();
      this.#followPublishedMap();
    }
  }

  /** Another map may have come in force. */
  #followPublishedMap() {
    const view = this.#floor && this.#state.floor(this.#floor.name);
    if (view && view.map !== this.#floor.version) {
      this.#loadMap();
    }
  }

  /** The map of the time shown, which hardly ever is another one. */
  #followReplayedMap() {
    const minute = MINUTE * Math.floor(this.#replay.time / MINUTE);
    if (minute !== this.#shownAt) {
      this.#loadMap(minute);
    }
  }

  /** Loads the map of the same floor again, as it is or was. */
  async #loadMap(at) {
    if (this.#isLoading) {
      return;
    }
    this.#isLoading = true;
    const name = this.#floor.name;
    try {
      const loaded = await Floor.load(name, at);
      if (this.#floor.name === name) {
        this.#shownAt = at;
        if (loaded.version !== this.#floor.version) {
          this.#floor = loaded;
          this.#canvas.requestFrame();
        }
      }
    } catch {
      this.#status.showLoadFailure();
    } finally {
      this.#isLoading = false;
    }
  }

  /** Shows the replay, or the live map after it. */
  #showMode() {
    const isReplay = this.#replay.isOpen;
    $('#map').classList.toggle('replayed', isReplay);
    for (const part of ['#counts', '#live-lists']) {
      $(part).hidden = isReplay;
    }
    for (const part of ['#replay-lists', '#attention-now']) {
      $(part).hidden = !isReplay;
    }
    if (isReplay) {
      this.#status.show();
      this.#canvas.requestFrame();
      updateReplayLists(this.#robotsInReplay, this.#replay);
    } else {
      this.#shownAt = undefined;
      this.#followPublishedMap();
      this.#showLive();
    }
  }

  #showLive() {
    this.#canvas.requestFrame();
    this.#filter.update(this.#floor ? this.#robotsHere : this.#state.robots);
    this.#shownRobots = this.#floor
      ? this.#robotsHere.map((robot) => ({...robot, faint: !this.#filter.includes(robot)}))
      : [];
    updateLiveLists(this.#state, this.#floor?.name, (robot) => this.#filter.includes(robot));
    this.#status.show();
  }

  #draw(context, viewport, colours, now) {
    if (!this.#floor) {
      return false;
    }
    viewport.centreOnTarget();
    this.#following.showBar();
    this.#floor.draw(context, viewport, colours, this.#margins.isOn);
    const goesOn = this.#replay.isOpen
      ? this.#drawReplay(context, viewport, colours, now)
      : this.#drawLive(context, viewport, colours, now);
    this.#measuring.draw(context, viewport, colours);
    return goesOn;
  }

  #drawLive(context, viewport, colours, now) {
    const view = this.#state.floor(this.#floor.name);
    const poseOf = (name) => this.#interpolator.poseOf(name, now);
    if (view) {
      if (this.#zones.isOn) {
        drawZones(context, viewport, colours, view.zones);
      }
      drawBlockedCells(context, viewport, colours, this.#floor, view);
      drawLeftLoads(context, viewport, colours, view.leftLoads);
    }
    const tasks = this.#state.tasksOn(this.#floor.name);
    drawTasks(context, viewport, colours, tasks);
    drawBoxes(context, viewport, colours, view?.boxes ?? []);
    const robots = this.#shownRobots;
    drawRobots(context, viewport, colours, robots, tasks, poseOf, view?.heldLoads);
    if (view) {
      drawAges(context, viewport, colours, this.#floor, view.seen, this.#state.time);
      drawStandstills(context, viewport, colours, view, robots, poseOf);
    }
    return this.#interpolator.isMoving(now);
  }

  #drawReplay(context, viewport, colours, now) {
    const isAdvancing = this.#replay.advance(now);
    this.#followReplayedMap();
    const poseOf = (name) => this.#replay.poseOf(name);
    const {loads} = this.#replay;
    const lying = loads.filter(({at}) => at).map(({at, size}) => ({where: at, size}));
    drawLeftLoads(context, viewport, colours, lying);
    const carried = loads
      .filter(({at}) => !at)
      .map(({task, robots, size}) => ({id: task, state: 'CARRYING', robots, size}));
    const robots = this.#robotsInReplay.map((robot) => {
      const task = carried.find((one) => one.robots.includes(robot.name))?.id;
      return replayedRobot(robot, poseOf(robot.name), this.#replay.pathOf(robot.name), task);
    });
    drawRobots(context, viewport, colours, robots, carried, poseOf);
    return isAdvancing;
  }

  /** Those that are here now, and those that were and have been removed. */
  get #robotsInReplay() {
    const removed = this.#replay.robots.filter((name) => !this.#state.robot(name));
    return [...this.#robotsHere, ...removed.map((name) => ({name, footprint: SMALLEST_FOOTPRINT}))];
  }

  get #robotsHere() {
    return this.#state.robotsOn(this.#floor.name);
  }

  #poseOf(name, now) {
    return this.#replay.isOpen ? this.#replay.poseOf(name) : this.#interpolator.poseOf(name, now);
  }

  #tap(x, y, metresPerPixel) {
    if (this.#measuring.isOpen && this.#floor) {
      this.#measuring.pick(x, y, metresPerPixel, this.#floor);
      return;
    }
    this.#following.followAt(x, y, metresPerPixel, this.#floor?.name, !this.#replay.isOpen);
  }

  /** Follows what the page's address names, such as ?robot=r1. */
  async #followRequested() {
    const query = new URLSearchParams(location.search);
    const robot = this.#state.robot(query.get('robot'));
    const task = this.#state.task(query.get('task'));
    const load = task ? undefined : this.#state.leftLoad(query.get('task'));
    const floor = robot?.floor ?? task?.floor ?? load?.floor;
    if (floor && floor !== this.#floor.name) {
      $('#floor').value = floor;
      await this.#showFloor(floor);
    }
    if (robot) {
      this.#following.followRobot(robot);
    } else if (task) {
      this.#following.followTask(task);
    } else if (load) {
      this.#following.followLeftLoad(load);
    }
  }

  async #showFloor(name) {
    try {
      this.#floor = await Floor.load(name);
      this.#shownAt = undefined;
      this.#actions.show(this.#floor.name);
      showCamerasOf(this.#floor.name, $('#cameras'));
      this.#measuring.close();
      this.#canvas.viewport.setBounds(this.#floor.bounds);
      this.#canvas.requestFrame();
      this.#replay.changeFloor();
      if (this.#hasSnapshot && !this.#replay.isOpen) {
        this.#showLive();
      }
    } catch {
      this.#status.showLoadFailure();
    }
  }
}

showCameras();
await new MapPage().start();
