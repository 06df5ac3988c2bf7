/** Where a point of a frame is on the map. */
export function onMap({x, y, theta}, [along, aside]) {
  const [cos, sin] = [Math.cos(theta), Math.sin(theta)];
  return [x + cos * along - sin * aside, y + sin * along + cos * aside];
}

/**
 * Shoulder, elbow and hand of an arm, metres; null where they are not known.
 *
 * @param pose of its robot on the map, or 0 for the robot's own frame
 */
export function armPoints(arm, pose) {
  if (!arm?.joints || pose.theta === undefined) {
    return null;
  }
  const {shoulder, elbow} = arm.joints;
  const base = onMap(pose, [arm.base.x, arm.base.y]);
  const frame = {x: base[0], y: base[1], theta: pose.theta + arm.base.theta};
  const bend = [arm.upperLink * Math.cos(shoulder), arm.upperLink * Math.sin(shoulder)];
  const reach = [arm.foreLink * Math.cos(shoulder + elbow), arm.foreLink * Math.sin(shoulder + elbow)];
  return [base, onMap(frame, bend), onMap(frame, [bend[0] + reach[0], bend[1] + reach[1]])];
}

/** Draws an arm as its two links, with a dot at each joint and a ring for the hand. */
export function drawArm(context, viewport, colours, arm, pose) {
  const points = armPoints(arm, pose)?.map(([x, y]) => viewport.toScreen(x, y));
  if (!points) {
    return;
  }
  context.lineJoin = 'round';
  context.lineCap = 'round';
  for (const [colour, width] of [['map-halo', 6], ['map-load-line', 3]]) {
    context.strokeStyle = colours[colour];
    context.lineWidth = width;
    context.beginPath();
    points.forEach(([x, y]) => context.lineTo(x, y));
    context.stroke();
  }
  context.fillStyle = colours['map-load-line'];
  for (const [x, y] of points.slice(0, 2)) {
    context.beginPath();
    context.arc(x, y, 3, 0, 2 * Math.PI);
    context.fill();
  }
  context.beginPath();
  context.arc(...points.at(-1), 4, 0, 2 * Math.PI);
  context.fillStyle = colours['map-halo'];
  context.fill();
  context.lineWidth = 2;
  context.stroke();
}
