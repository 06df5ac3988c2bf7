package org.toqa.avoidance.fouragents;

/**
 * The numbers of the four agents. Those of the seed are 50 mm (the dangerous zone) and 100 mm
 * (where only the target counts); all others are ours, since its figures and tables are lost.
 *
 * @param body the robot
 * @param sensorRange metres from the rim
 * @param danger metres from the rim: nearer than that an unknown obstacle is dangerous
 * @param arrival metres: nearer than that to the target navigation has its full utility
 * @param margin metres that a convergence circle leaves between rim and static obstacle
 * @param approach metres outside a convergence circle over which the utility of static avoidance
 *     rises from 0 to 1. With 0 it is as in the seed's text: none outside, so on the circle itself
 *     navigation drives
 * @param cruise the utility of navigation far from the target, 0 to 1
 * @param hysteresis by how much another agent's utility must be larger before that one drives
 * @param tolerance metres by which readings of known obstacles may be wrong
 * @param convergence of the limit cycle ({@link LimitCycle})
 */
public record FourAgentsSettings(
    DifferentialBody body,
    double sensorRange,
    double danger,
    double arrival,
    double margin,
    double approach,
    double cruise,
    double hysteresis,
    double tolerance,
    double convergence) {

  /** Seconds between two looks of the sensors, in which a robot drives on. */
  private static final double REACTION = 0.1;

  /** Metres that the seed's robot needs to stop: what its 50 and 100 mm are measured against. */
  private static final double STOPPING_OF_SEED = reach(DifferentialBody.KHEPERA_II);

  /**
   * For a robot: the seed's lengths grow in proportion to what it needs to stop, reaction included.
   */
  public static FourAgentsSettings of(DifferentialBody body) {
    double scale = reach(body) / STOPPING_OF_SEED;
    return new FourAgentsSettings(
        body,
        0.100 * scale,
        0.050 * scale,
        0.100 * scale,
        0.020 * scale,
        0.020 * scale,
        0.3,
        0.1,
        0.010 * scale,
        1);
  }

  private static double reach(DifferentialBody body) {
    return body.wheelSpeed() * REACTION + body.stoppingDistance();
  }

  /** The same with another margin of the convergence circles, metres. */
  public FourAgentsSettings withMargin(double metres) {
    return new FourAgentsSettings(
        body,
        sensorRange,
        danger,
        arrival,
        metres,
        approach,
        cruise,
        hysteresis,
        tolerance,
        convergence);
  }

  /** The same with another rise of the utility of static avoidance, metres. */
  public FourAgentsSettings withApproach(double metres) {
    return new FourAgentsSettings(
        body,
        sensorRange,
        danger,
        arrival,
        margin,
        metres,
        cruise,
        hysteresis,
        tolerance,
        convergence);
  }

  /** The same with another distance from the target within which only that counts, metres. */
  public FourAgentsSettings withArrival(double metres) {
    return new FourAgentsSettings(
        body,
        sensorRange,
        danger,
        metres,
        margin,
        approach,
        cruise,
        hysteresis,
        tolerance,
        convergence);
  }

  /** The same with another dangerous zone, metres. */
  public FourAgentsSettings withDanger(double metres) {
    return new FourAgentsSettings(
        body,
        sensorRange,
        metres,
        arrival,
        margin,
        approach,
        cruise,
        hysteresis,
        tolerance,
        convergence);
  }

  /** The same with sensors that see as far as that, metres from the rim. */
  public FourAgentsSettings withSensorRange(double metres) {
    return new FourAgentsSettings(
        body,
        metres,
        danger,
        arrival,
        margin,
        approach,
        cruise,
        hysteresis,
        tolerance,
        convergence);
  }

  /** The same with another hysteresis. */
  public FourAgentsSettings withHysteresis(double difference) {
    return new FourAgentsSettings(
        body,
        sensorRange,
        danger,
        arrival,
        margin,
        approach,
        cruise,
        difference,
        tolerance,
        convergence);
  }

  /** The sensors of such a robot. */
  public RangeRing ring() {
    return new RangeRing(body.radius(), sensorRange);
  }
}
