/** The shorter way from one direction to the other, radians. */
export function turn(from, to) {
  const difference = (to - from) % (2 * Math.PI);
  return difference > Math.PI
    ? difference - 2 * Math.PI
    : difference <= -Math.PI
      ? difference + 2 * Math.PI
      : difference;
}
