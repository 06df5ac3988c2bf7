package org.toqa.web;

import io.micrometer.core.instrument.Counter;
import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.MeterRegistry;
import io.micrometer.core.instrument.MultiGauge;
import io.micrometer.core.instrument.Tags;
import io.micrometer.core.instrument.Timer;
import io.micrometer.core.instrument.binder.jvm.JvmGcMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.core.instrument.binder.system.FileDescriptorMetrics;
import io.micrometer.core.instrument.binder.system.ProcessorMetrics;
import io.micrometer.core.instrument.binder.system.UptimeMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.mission.TaskState;

/**
 * What is measured of the fleet, the pages and the process, as Prometheus reads it. {@code
 * docs/operations.md} explains each.
 */
public final class Metrics implements AutoCloseable {
  private final PrometheusMeterRegistry registry =
      new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);

  /** What tells of all sites and of strangers. */
  private final PrometheusMeterRegistry ofServer =
      new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);

  private final MeterRegistry requests;
  private final SnapshotFeed feed;
  private final MultiGauge robots;
  private final MultiGauge tasks;
  private final MultiGauge batteries;
  private final JvmGcMetrics gcMetrics = new JvmGcMetrics();
  private final AtomicInteger streams = new AtomicInteger();
  private final Counter rateLimited;

  /** Those of a site beside the first one. */
  public Metrics(SnapshotFeed feed) {
    this(feed, false);
  }

  /**
   * @param isFirst whether it is the site whose pages whoever is not signed in asks for, and that
   *     is also told how the process does
   */
  public Metrics(SnapshotFeed feed, boolean isFirst) {
    this.feed = feed;
    requests = isFirst ? ofServer : registry;
    robots =
        MultiGauge.builder("toqa.robots").description("Robots in each state").register(registry);
    tasks =
        MultiGauge.builder("toqa.tasks")
            .description("Tasks in each state, those in the queue and those that robots have")
            .register(registry);
    batteries =
        MultiGauge.builder("toqa.robot.battery.ratio")
            .description("What each robot's battery has, 0 to 1")
            .register(registry);
    gauge("toqa.fleet.paused", "1 while all robots are paused", s -> s.pause() == null ? 0 : 1);
    gauge("toqa.fleet.alerts", "What ails the whole fleet", s -> s.alerts().size());
    gauge(
        "toqa.robots.faulty",
        "Robots that report an error or are not trusted",
        s ->
            s.robots().stream()
                .filter(r -> !r.telemetry().errors().isEmpty() || r.alert() != null)
                .count());
    Gauge.builder("toqa.streams", streams, AtomicInteger::get)
        .description("Readers of live events")
        .register(registry);
    rateLimited =
        Counter.builder("toqa.http.too.fast")
            .description("Requests that were refused because their caller asked too fast")
            .register(requests);
    if (isFirst) {
      bindProcess();
    }
  }

  private void bindProcess() {
    new JvmMemoryMetrics().bindTo(ofServer);
    new JvmThreadMetrics().bindTo(ofServer);
    new ProcessorMetrics().bindTo(ofServer);
    new UptimeMetrics().bindTo(ofServer);
    new FileDescriptorMetrics().bindTo(ofServer);
    gcMetrics.bindTo(ofServer);
  }

  private void gauge(String name, String description, ToDoubleFunction<FleetSnapshot> value) {
    Gauge.builder(name, feed, f -> value.applyAsDouble(f.latest()))
        .description(description)
        .register(registry);
  }

  /**
   * From now on it is also told how much of what robots say is left out.
   *
   * @param count since the start, by the kind of message; any thread may ask
   */
  public void bindPassedOver(ToDoubleFunction<RobotMessageKind> count) {
    for (RobotMessageKind kind : RobotMessageKind.values()) {
      FunctionCounter.builder("toqa.robot.messages.left.out", kind, count)
          .description("Messages of robots beyond what one may say")
          .tag("kind", kind.label())
          .register(registry);
    }
  }

  /** For parts that measure themselves. */
  public MeterRegistry registry() {
    return registry;
  }

  /**
   * A request was answered.
   *
   * @param route its path, with braces, so that there are not more of them than routes
   */
  public void recordRequest(String method, String route, int status, Duration time) {
    Timer.builder("toqa.http.requests")
        .description("Answered requests of pages and API")
        .publishPercentileHistogram()
        .minimumExpectedValue(Duration.ofMillis(1))
        .maximumExpectedValue(Duration.ofSeconds(10))
        .tags("method", method, "door", route, "status", status / 100 + "xx")
        .register(requests)
        .record(time);
  }

  public void recordRateLimited() {
    rateLimited.increment();
  }

  public void recordStreamStart() {
    streams.incrementAndGet();
  }

  public void recordStreamEnd() {
    streams.decrementAndGet();
  }

  /**
   * What is measured, in Prometheus' text format.
   *
   * @param withServer also what tells of other sites and of strangers
   */
  public String scrape(boolean withServer) {
    FleetSnapshot fleet = feed.latest();
    robots.register(
        states(
            RobotState.values(),
            state -> fleet.robots().stream().filter(r -> r.state() == state).count()),
        true);
    tasks.register(
        states(
            Arrays.stream(TaskState.values()).filter(s -> !s.isEnded()).toArray(TaskState[]::new),
            state ->
                state == TaskState.QUEUED
                    ? fleet.queuedCount()
                    : fleet.tasks().stream().filter(t -> t.state() == state).count()),
        true);
    batteries.register(fleet.robots().stream().flatMap(Metrics::battery).toList(), true);
    return withServer ? registry.scrape() + ofServer.scrape() : registry.scrape();
  }

  private static <S extends Enum<S>> List<MultiGauge.Row<?>> states(
      S[] states, Function<S, Number> count) {
    return Arrays.stream(states)
        .<MultiGauge.Row<?>>map(
            state ->
                MultiGauge.Row.of(
                    Tags.of("state", state.name().toLowerCase(Locale.ROOT)), count.apply(state)))
        .toList();
  }

  private static Stream<MultiGauge.Row<?>> battery(RobotView robot) {
    Double battery = robot.telemetry().battery();
    return battery == null
        ? Stream.empty()
        : Stream.of(MultiGauge.Row.of(Tags.of("robot", robot.name()), battery));
  }

  @Override
  public void close() {
    gcMetrics.close();
    ofServer.close();
    registry.close();
  }
}
