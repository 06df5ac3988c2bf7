import {fetchJson} from '../shared/server.js';
import {remainingPath} from './remaining-path.js';
import {Trajectory} from './trajectory.js';

const CHUNK = 600_000; // milliseconds that are fetched at once
const KEPT_CHUNKS = 12;
const MAX_EVENTS = 1000; // of a chunk and the one before it

/** With times since 1970; what has not ended lasts on. */
const absolute = (one, begin) => ({
  ...one,
  from: begin + one.from,
  until: one.until === null ? Infinity : begin + one.until,
});
const isWithin = ({from, until}, time) => from <= time && time < until;
const chunkOf = (time) => Math.floor(time / CHUNK) * CHUNK;

/** Tracks, loads, planned paths and events of a floor, fetched in chunks as they are needed. Times are milliseconds since 1970. */
export class ReplayData {
  #floor;
  #end;
  #onLoad;
  #chunks = new Map(); // by the time at which each begins
  #requested = 0;
  #isLoading = false;

  /**
   * @param end up to which there are data
   * @param onLoad called when a chunk has been loaded
   */
  constructor(floor, end, onLoad) {
    this.#floor = floor;
    this.#end = end;
    this.#onLoad = onLoad;
  }

  isLoaded(time) {
    return this.#chunks.has(chunkOf(time));
  }

  /** Fetches the chunk of that time, and the next one. */
  async load(time) {
    this.#requested = time;
    if (this.#isLoading) {
      return;
    }
    this.#isLoading = true;
    try {
      for (let begin = this.#missing(); begin !== undefined; begin = this.#missing()) {
        this.#store(begin, await this.#fetch(begin));
      }
    } finally {
      this.#isLoading = false;
    }
  }

  /** The pose of a robot; undefined where it is not known. */
  poseOf(robot, time) {
    return this.#chunks.get(chunkOf(time))?.trajectories.get(robot)?.poseAt(time);
  }

  /** The names of those that have a track at that time, also of robots that were removed since. */
  robots(time) {
    return [...(this.#chunks.get(chunkOf(time))?.trajectories.keys() ?? [])];
  }

  /** The loads that there were: each with its task, where it was, or the robots that carried it. */
  loads(time) {
    return (this.#chunks.get(chunkOf(time))?.loads ?? []).filter((load) => isWithin(load, time));
  }

  /** The points that a robot had ahead, from where it was; empty where it had no path. */
  pathOf(robot, time) {
    const paths = this.#chunks.get(chunkOf(time))?.paths.get(robot) ?? [];
    const path = paths.find((one) => isWithin(one, time));
    const pose = path && this.poseOf(robot, time);
    return pose ? remainingPath(path.points, pose) : [];
  }

  /** The latest events before that time, newest first. */
  events(time) {
    const events = this.#chunks.get(chunkOf(time))?.events ?? [];
    return events.filter(({at}) => Date.parse(at) <= time);
  }

  #missing() {
    const begin = chunkOf(this.#requested);
    return [begin, begin + CHUNK].find((time) => time < this.#end && !this.#chunks.has(time));
  }

  #store(begin, chunk) {
    this.#chunks.set(begin, chunk);
    if (this.#chunks.size > KEPT_CHUNKS) {
      this.#chunks.delete(this.#chunks.keys().next().value);
    }
    this.#onLoad();
  }

  async #fetch(begin) {
    const until = new Date(begin + CHUNK).toISOString();
    const before = new Date(begin - CHUNK).toISOString();
    const [{tracks, loads, paths}, {events}] = await Promise.all([
      this.#fetchTracks(begin, until),
      fetchJson(`api/v1/history?from=${before}&until=${until}&limit=${MAX_EVENTS}`),
    ]);
    return {
      trajectories: new Map([...tracks].map(([robot, track]) => [robot, new Trajectory(track)])),
      loads: [...loads.values()],
      paths: Map.groupBy(paths.values(), ({robot}) => robot),
      events: events.filter(({kind}) => !/^(user|notice)\./.test(kind)),
    };
  }

  /**
   * The points of each robot, and all loads' places and paths; the server answers for a shorter time
   * where there are very many, and what lasts then comes twice.
   */
  async #fetchTracks(begin, until) {
    const [tracks, loads, paths] = [new Map(), new Map(), new Map()];
    for (let from = begin; from < Date.parse(until); ) {
      const query = new URLSearchParams({floor: this.#floor, from: new Date(from).toISOString(), until});
      const answer = await fetchJson(`api/v1/tracks?${query}`);
      for (const {robot, points} of answer.robots) {
        const track = tracks.get(robot) ?? [];
        const last = track.at(-1)?.[0] ?? -Infinity;
        const added = points.map(([after, x, y]) => [from + after, x, y]);
        tracks.set(robot, [...track, ...added.filter(([at]) => at > last)]);
      }
      for (const load of answer.loads) {
        loads.set(`${load.load} ${from + load.from}`, absolute(load, from));
      }
      for (const path of answer.paths) {
        paths.set(`${path.robot} ${from + path.from}`, absolute(path, from));
      }
      from = Date.parse(answer.until);
    }
    return {tracks, loads, paths};
  }
}
