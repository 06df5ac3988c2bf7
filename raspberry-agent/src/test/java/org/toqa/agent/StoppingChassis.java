package org.toqa.agent;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.ChassisCommand;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.link.message.AgentMessage.Fault;

/** A body that stops itself as the firmware does, when the test says so. */
final class StoppingChassis implements Chassis {
  private final Chassis body;
  private final Set<String> stops = new TreeSet<>();
  private final List<Set<String>> cleared = new ArrayList<>();

  StoppingChassis(Chassis body) {
    this.body = body;
  }

  /** Stops the wheels for this reason until it is cleared. */
  void stop(String code) {
    stops.add(code);
  }

  /** What it was told to clear, in order. */
  List<Set<String>> cleared() {
    return List.copyOf(cleared);
  }

  @Override
  public ChassisReading exchange(ChassisCommand command, long nanos) {
    ChassisReading now =
        body.exchange(stops.isEmpty() ? command : ChassisCommand.MoveAt.STANDSTILL, nanos);
    return now.withFaults(
        Stream.concat(
                now.faults().stream(), stops.stream().map(code -> new Fault(code, code, true)))
            .toList());
  }

  @Override
  public void clearStops(Set<String> reasons) {
    cleared.add(reasons);
    stops.removeAll(reasons);
  }

  @Override
  public void close() {
    body.close();
  }
}
