package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.toqa.link.RobotLink;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.wording.Sentence;

/** What a link to a robot has told, in order, to be taken out piece by piece. */
public final class LinkRecorder implements RobotLink.Listener {
  private static final long LIMIT_SECONDS = 20;

  private final AtomicLong passedOver = new AtomicLong();
  private volatile boolean isFull;
  private final AtomicBoolean failsNext = new AtomicBoolean();
  private final BlockingQueue<String> faults = new LinkedBlockingQueue<>();
  private final BlockingQueue<Object> told = new LinkedBlockingQueue<>();

  /** That the link ended. */
  public record End(String sentence) {}

  /** That one end does not accept the other. */
  public record Refusal(String sentence) {}

  @Override
  public void connected(Hello hello) {
    told.add(hello);
  }

  @Override
  public boolean received(AgentMessage message) {
    if (failsNext.getAndSet(false)) {
      throw new IllegalStateException("said by the test");
    }
    told.add(message);
    return !isFull;
  }

  @Override
  public void passedOver(int states, int unreadable) {
    passedOver.addAndGet(states);
  }

  @Override
  public void misunderstood(String fault) {
    faults.add(fault);
  }

  /** What is wrong with the next line that makes no sense. */
  public String nextFault() throws InterruptedException {
    String next = faults.poll(LIMIT_SECONDS, TimeUnit.SECONDS);
    assertNotNull(next, "nothing was wrong");
    return next;
  }

  /** From now on it can take nothing more. */
  public void setFull() {
    isFull = true;
  }

  /** The next message surprises it. */
  public void failNext() {
    failsNext.set(true);
  }

  /** How many states newer ones superseded. */
  public long passedOver() {
    return passedOver.get();
  }

  @Override
  public void disconnected(Sentence why) {
    told.add(new End(why.english()));
  }

  @Override
  public void refused(Sentence sentence) {
    told.add(new Refusal(sentence.english()));
  }

  public boolean isEmpty() {
    return told.isEmpty();
  }

  /** The next that was told, of whatever kind. */
  public Object next() throws InterruptedException {
    Object next = told.poll(LIMIT_SECONDS, TimeUnit.SECONDS);
    assertNotNull(next, "nothing was told");
    return next;
  }

  /** The next of this kind; what comes before it is skipped. */
  public <T> T await(Class<T> kind) throws InterruptedException {
    return await(kind, any -> true);
  }

  /** The next of this kind that is wanted; what comes before it is skipped. */
  public <T> T await(Class<T> kind, Predicate<T> wanted) throws InterruptedException {
    while (true) {
      Object next = next();
      if (kind.isInstance(next) && wanted.test(kind.cast(next))) {
        return kind.cast(next);
      }
    }
  }

  @Override
  public String toString() {
    return told.toString();
  }
}
