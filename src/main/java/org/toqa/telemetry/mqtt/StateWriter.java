package org.toqa.telemetry.mqtt;

import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;

/** Writes what the server publishes of robots and tasks: JSON, UTF-8. */
public interface StateWriter {
  byte[] robot(RobotView robot);

  byte[] task(TaskView task);
}
