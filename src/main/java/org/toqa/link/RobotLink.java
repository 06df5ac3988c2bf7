package org.toqa.link;

import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.wording.Sentence;

/**
 * The server's end of the link to one robot; it connects, and connects again, by itself.
 *
 * <ol>
 *   <li>{@link Listener#connected} brings the robot's hello.
 *   <li>{@link #send} queues a message and never waits; what is sent while there is no connection
 *       is dropped, since the next hello tells what the robot knows.
 *   <li>{@link Listener#received} brings what the robot says; of states that come faster than they
 *       can be read the newest.
 *   <li>{@link Listener#disconnected} or {@link Listener#refused} says why the connection ended or
 *       could not be made; the link goes on trying until {@link #close}.
 * </ol>
 *
 * Any thread may call it; the listener is called by the link's own threads, one call at a time.
 */
public interface RobotLink extends AutoCloseable {

  void send(ServerMessage message);

  @Override
  void close();

  /** Is told what happens on a link. */
  interface Listener {
    void connected(Hello hello);

    /**
     * @return false: the robot says more than can be taken, so the connection is to end
     */
    boolean received(AgentMessage message);

    /**
     * Some of what the robot said was passed over.
     *
     * @param states for newer ones had come already
     * @param unreadable lines that make no sense
     */
    void passedOver(int states, int unreadable);

    /**
     * What is wrong with a line that makes no sense.
     *
     * @param fault a sentence
     */
    default void misunderstood(String fault) {}

    /**
     * @param why and what to do
     */
    void disconnected(Sentence why);

    /**
     * The same, and one end does not trust the other: a person must look into it.
     *
     * @param why and what to do
     */
    void refused(Sentence why);
  }
}
