package org.toqa.link;

/** Opens links to robots. */
public interface RobotLinks {

  /**
   * @param robot the name that the robot must say in its hello
   */
  RobotLink open(String robot, String host, int port, RobotLink.Listener listener);
}
