import {numberIn} from '../shared/locale.js';

/** The fields of a place: a station, or coordinates. */
export class PlaceFields {
  /**
   * @param name of the place
   * @param station select of the stations
   * @param x input in metres
   * @param y likewise
   */
  constructor(name, station, x, y) {
    Object.assign(this, {name, station, x, y});
  }

  /** As the API takes it; undefined while it is incomplete. */
  get value() {
    if (this.station.value) {
      return {station: this.station.value};
    }
    const point = {x: numberIn(this.x), y: numberIn(this.y)};
    return point.x === undefined || point.y === undefined ? undefined : point;
  }

  /** Its map point; undefined while it is incomplete. */
  pointOn(floor) {
    const {value} = this;
    return value?.station ? floor.stations.find(({name}) => name === value.station) : value;
  }

  setStation(name) {
    this.station.value = name;
    this.x.value = '';
    this.y.value = '';
  }

  setPoint(x, y) {
    this.station.value = '';
    this.x.value = x.toFixed(2);
    this.y.value = y.toFixed(2);
  }

  onChange(listener) {
    this.station.addEventListener('change', () => {
      if (this.station.value) {
        this.setStation(this.station.value);
      }
      listener();
    });
    for (const coordinate of [this.x, this.y]) {
      coordinate.addEventListener('input', () => {
        this.station.value = '';
        listener();
      });
    }
  }
}
