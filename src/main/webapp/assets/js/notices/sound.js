/** Two short tones, hertz, and when each begins, seconds. */
const TONES = [[880, 0], [660, 0.18]];
const LENGTH = 0.16; // seconds
const LOUDNESS = 0.2;

/** Plays the sound of a notice; a browser that lets no page sound before it was touched stays silent. */
export async function playSound() {
  const context = new AudioContext();
  // a browser that waits for a touch never answers
  await Promise.race([context.resume(), new Promise((done) => setTimeout(done, 500))]);
  if (context.state !== 'running') {
    await context.close();
    return false;
  }
  for (const [frequency, at] of TONES) {
    const begin = context.currentTime + at;
    const tone = new OscillatorNode(context, {frequency});
    const volume = new GainNode(context, {gain: 0});
    volume.gain.setValueAtTime(0, begin);
    volume.gain.linearRampToValueAtTime(LOUDNESS, begin + 0.02);
    volume.gain.linearRampToValueAtTime(0, begin + LENGTH);
    tone.connect(volume).connect(context.destination);
    tone.start(begin);
    tone.stop(begin + LENGTH);
  }
  setTimeout(() => context.close(), 1000);
  return true;
}
