package org.toqa.agent;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.Chassis;
import org.toqa.agent.chassis.SimulatedArm;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.firmware.FirmwareChassis;
import org.toqa.agent.firmware.FirmwareSettings;
import org.toqa.agent.firmware.FrameTransport;
import org.toqa.agent.firmware.SerialTransport;
import org.toqa.agent.firmware.SimulatorTransport;
import org.toqa.agent.firmware.SpidevTransport;
import org.toqa.agent.http.HttpChassis;
import org.toqa.geometry.Pose;

/** Opens the body that a configuration names. */
final class ChassisFactory {

  private ChassisFactory() {}

  /**
   * @param folder the daemon's, where a simulated body keeps its state
   * @param nanos the time of the first tick, on a monotonic clock
   * @throws IOException with one line for people: there is no such body
   */
  static Chassis open(AgentConfig config, Path folder, long nanos) throws IOException {
    return switch (config.chassis()) {
      case ChassisConfig.Simulated body ->
          withArm(
              new SimulatedChassis(
                  folder.resolve("body"),
                  body.start(),
                  body.battery(),
                  SimulatedWheels.of(config.kind(), body.noise()),
                  body.seed(),
                  config.rangeSensors(),
                  body.surroundings()),
              config.arm(),
              folder);
      case ChassisConfig.Http(var robot, var description, var listener, var ranges) ->
          HttpChassis.open(robot, description, listener, ranges, folder.resolve("odometry"), nanos);
      case ChassisConfig.SimulatedFirmware(var socket, var start, var ranges, var settings) ->
          openFirmware(config, new SimulatorTransport(socket), start, ranges, settings, nanos);
      case ChassisConfig.Spi(var device, var hertz, var wordDelay, var ranges, var settings) ->
          openFirmware(
              config, new SpidevTransport(device, hertz, wordDelay), null, ranges, settings, nanos);
      case ChassisConfig.Serial(var device, var baud, var ranges, var settings) ->
          openFirmware(config, new SerialTransport(device, baud), null, ranges, settings, nanos);
    };
  }

  private static Chassis withArm(SimulatedChassis body, @Nullable ArmConfig arm, Path folder)
      throws IOException {
    if (arm != null) {
      try {
        body.mount(new SimulatedArm(folder.resolve("arm"), arm.arm(), arm.boxWeight(), body));
      } catch (IOException e) {
        body.close();
        throw e;
      }
    }
    return body;
  }

  private static Chassis openFirmware(
      AgentConfig config,
      FrameTransport transport,
      @Nullable Pose start,
      boolean hasRangeSensors,
      FirmwareSettings settings,
      long nanos)
      throws IOException {
    String caption = config.name() + " " + config.address().getHostAddress();
    try {
      ArmConfig arm = config.arm();
      return new FirmwareChassis(
          transport,
          caption,
          start,
          hasRangeSensors,
          settings,
          arm == null ? null : arm.settings(),
          nanos);
    } catch (IOException e) {
      transport.close();
      throw e;
    }
  }
}
