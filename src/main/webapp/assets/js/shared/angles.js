/** The signed turn from one direction to the other by the shorter side, radians in (-pi, pi]. */
export function angleDifference(from, to) {
  const difference = (to - from) % (2 * Math.PI);
  return difference > Math.PI
    ? difference - 2 * Math.PI
    : difference <= -Math.PI
      ? difference + 2 * Math.PI
      : difference;
}

/** A heading as people are told it: whole degrees from 0 to 359. */
export function headingDegrees(radians) {
  return (Math.round(radians * 180 / Math.PI) % 360 + 360) % 360;
}
