package org.toqa.app.bench;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.app.bench.meter.LatencyHistogram;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.geometry.Pose;
import tools.jackson.databind.JsonNode;

/**
 * A live map in Chromium, which notes its own pictures: a picture with a pose is drawn when the
 * first frame after the event with that pose is. The map glides to the pose within the time between
 * two events; that is not waited for.
 */
final class LiveMapPage implements AutoCloseable {
  /** Milliseconds: the page's clock is the machine's, to a millisecond. */
  private static final String SCRIPT =
      """
      (() => {
        let pictures = [];
        let frames = [];
        const listen = EventSource.prototype.addEventListener;
        EventSource.prototype.addEventListener = function (type, listener) {
          listen.call(this, type, (event) => {
            const at = Date.now();
            listener.call(this, event);
            if (type === 'snapshot' || type === 'change') {
              const robots = (JSON.parse(event.data).robots ?? [])
                .filter(({pose}) => pose)
                .map(({name, pose}) => ({name, pose}));
              requestAnimationFrame(() => pictures.push({at, drawn: Date.now(), robots}));
            }
          });
        };
        let last;
        const count = () => {
          const now = performance.now();
          if (last !== undefined) {
            frames.push(now - last);
          }
          last = now;
          requestAnimationFrame(count);
        };
        requestAnimationFrame(count);
        globalThis.takeMeasured = () => {
          const measured = {pictures, frames};
          pictures = [];
          frames = [];
          return measured;
        };
      })();
      """;

  private static final long FIRST_PICTURE_LIMIT = 60_000_000_000L;
  private static final int POLL_MILLIS = 100;

  private final HeadlessChromium chromium;
  private final PoseReports reports;
  private final Map<String, Pose> lastPoses = new HashMap<>();
  private final LatencyHistogram drawing = new LatencyHistogram();
  private final LatencyHistogram drawn = new LatencyHistogram();
  private final List<Double> frameMillis = new ArrayList<>();

  private LiveMapPage(HeadlessChromium chromium, PoseReports reports) {
    this.chromium = chromium;
    this.reports = reports;
  }

  /**
   * Returns when it has drawn its first picture of a robot.
   *
   * @param page the address of the map
   * @param reports of the robots that it shows
   * @throws IOException Chromium cannot be used, or the page shows nothing within a minute
   */
  static LiveMapPage open(Path program, URI page, String token, PoseReports reports)
      throws IOException, InterruptedException {
    HeadlessChromium chromium = HeadlessChromium.start(program);
    try {
      chromium.open(page, token, SCRIPT);
      LiveMapPage map = new LiveMapPage(chromium, reports);
      map.awaitFirstPicture();
      return map;
    } catch (IOException | InterruptedException e) {
      chromium.close();
      throw e;
    }
  }

  private void awaitFirstPicture() throws IOException, InterruptedException {
    long end = System.nanoTime() + FIRST_PICTURE_LIMIT;
    while (lastPoses.isEmpty()) {
      if (System.nanoTime() > end) {
        throw new IOException("The live map in Chromium shows no robot.");
      }
      Thread.sleep(POLL_MILLIS);
      collect();
    }
  }

  /**
   * Takes over what the page has noted since; at least every 20 s, for so long reports are kept.
   */
  void collect() throws IOException, InterruptedException {
    JsonNode measured = chromium.evaluate("globalThis.takeMeasured?.() ?? {}");
    for (JsonNode picture : measured.path("pictures")) {
      Instant received = Instant.ofEpochMilli(picture.path("at").asLong());
      Instant shown = Instant.ofEpochMilli(picture.path("drawn").asLong());
      drawing.add(received, shown);
      for (JsonNode robot : picture.path("robots")) {
        String name = robot.path("name").asString();
        Pose pose = PoseLatencies.poseOf(robot);
        Pose before = pose == null ? null : lastPoses.put(name, pose);
        if (pose != null && before != null && !before.equals(pose)) {
          reports.find(name, pose).ifPresent(reported -> drawn.add(reported, shown));
        }
      }
    }
    measured.path("frames").forEach(frame -> frameMillis.add(frame.asDouble()));
  }

  /** Discards what was noted so far. */
  void reset() throws IOException, InterruptedException {
    collect();
    drawing.reset();
    drawn.reset();
    frameMillis.clear();
  }

  /** From an event's arrival in the page until the first picture with it was drawn. */
  LatencySummary drawing() {
    return drawing.summary();
  }

  /** From a robot's report until the first picture with it was drawn. */
  LatencySummary drawn() {
    return drawn.summary();
  }

  /** From one frame to the next. */
  double[] frameMillis() {
    return frameMillis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  @Override
  public void close() {
    chromium.close();
  }
}
