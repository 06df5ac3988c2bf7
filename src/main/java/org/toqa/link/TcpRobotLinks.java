package org.toqa.link;

/** Links over TCP, not encrypted. */
public final class TcpRobotLinks implements RobotLinks {

  private final boolean offLoopbackToo;

  /**
   * @param offLoopbackToo whether robots on other machines may be spoken to without encryption;
   *     where not, such a link only says so
   */
  public TcpRobotLinks(boolean offLoopbackToo) {
    this.offLoopbackToo = offLoopbackToo;
  }

  @Override
  public RobotLink open(String robot, String host, int port, RobotLink.Listener listener) {
    TcpRobotLink link = new TcpRobotLink(robot, host, port, offLoopbackToo, listener);
    link.start();
    return link;
  }
}
