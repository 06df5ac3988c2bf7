/** The signed turn from one direction to the other by the shorter side, radians in (-pi, pi]. */
export function angleDifference(from, to) {
  const difference = (to - from) % (2 * Math.PI);
  return difference > Math.PI
    ? difference - 2 * Math.PI
    : difference <= -Math.PI
      ? difference + 2 * Math.PI
      : difference;
}
