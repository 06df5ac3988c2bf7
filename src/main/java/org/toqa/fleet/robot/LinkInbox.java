package org.toqa.fleet.robot;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.link.RobotLink;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.wording.Sentence;

/**
 * What a link has told and its agent has not taken yet. Of states with the same faults only the
 * newest waits; all else is kept in its order, up to {@link #CAPACITY}.
 *
 * <ol>
 *   <li>The link's thread puts in what it is told.
 *   <li>The agent is woken by one message, however much comes.
 *   <li>The agent takes one by {@link #poll}, and says by {@link #finish} that it is done, so that
 *       others who tell it something wait for one message only.
 * </ol>
 */
final class LinkInbox implements RobotLink.Listener {
  /** So many messages wait at most. */
  static final int CAPACITY = 1_000;

  private final Consumer<LinkInbox> wake;
  private final Deque<RobotMessage> waiting = new ArrayDeque<>();

  /** The last state that waits. */
  private @Nullable State newest;

  /** What is wrong with a line that has come since the last state. */
  private @Nullable String fault;

  private boolean isWoken;
  private long superseded;
  private long unreadable;
  private long overflows;

  /**
   * What is not in the inbox, though the robot said it.
   *
   * @param superseded states that newer ones took the place of
   * @param unreadable lines that made no sense
   * @param overflows how often the link was to be closed, since more waited than may
   */
  record PassedOver(long superseded, long unreadable, long overflows) {}

  /**
   * @param wake is called when there is something to be taken; once until it is
   */
  LinkInbox(Consumer<LinkInbox> wake) {
    this.wake = wake;
  }

  /** The oldest that waits; null: there is nothing. */
  synchronized @Nullable RobotMessage poll() {
    RobotMessage next = waiting.pollFirst();
    if (next instanceof RobotMessage.MessageReceived(State state) && state.equals(newest)) {
      newest = null;
    }
    return next;
  }

  /** What is wrong with what the robot has said since its last state; null: nothing. */
  synchronized @Nullable String fault() {
    return fault;
  }

  /** What was passed over since the last call. */
  synchronized PassedOver takePassedOver() {
    PassedOver taken = new PassedOver(superseded, unreadable, overflows);
    superseded = 0;
    unreadable = 0;
    overflows = 0;
    return taken;
  }

  /** What woke the agent is done; wakes it again if more waits. */
  synchronized void finish() {
    isWoken = !waiting.isEmpty();
    if (isWoken) {
      wake.accept(this);
    }
  }

  /** What the last connection said counts no more: the hello tells what the robot knows. */
  @Override
  public synchronized void connected(Hello said) {
    clear();
    add(new RobotMessage.LinkOpened(said));
  }

  @Override
  public synchronized boolean received(AgentMessage message) {
    RobotMessage.MessageReceived next = new RobotMessage.MessageReceived(message);
    if (message instanceof State state) {
      if (newest != null && faults(newest).equals(faults(state))) {
        remove(newest);
        superseded++;
      }
      newest = state;
      fault = null;
    }
    if (waiting.size() >= CAPACITY) {
      overflows++;
      return false;
    }
    add(next);
    return true;
  }

  @Override
  public synchronized void passedOver(int states, int lines) {
    superseded += states;
    unreadable += lines;
  }

  @Override
  public synchronized void misunderstood(String what) {
    fault = what;
  }

  @Override
  public synchronized void disconnected(Sentence why) {
    add(new RobotMessage.LinkClosed(why));
  }

  @Override
  public synchronized void refused(Sentence why) {
    add(new RobotMessage.LinkRefused(why));
  }

  private void add(RobotMessage message) {
    waiting.addLast(message);
    if (!isWoken) {
      isWoken = true;
      wake.accept(this);
    }
  }

  private void remove(State state) {
    for (Iterator<RobotMessage> each = waiting.descendingIterator(); each.hasNext(); ) {
      if (each.next() instanceof RobotMessage.MessageReceived(State last) && last.equals(state)) {
        each.remove();
        return;
      }
    }
  }

  private void clear() {
    waiting.clear();
    newest = null;
    fault = null;
  }

  private static Set<String> faults(State state) {
    return state.errors().stream().map(Fault::code).collect(Collectors.toSet());
  }
}
