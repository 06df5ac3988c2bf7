package org.toqa.fleet.dispatch;

import java.util.function.Consumer;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.Answer;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.persistence.StoreException;

/**
 * Who asked for a robot, and waits for the answer.
 *
 * @param onStored goes on with the robot, and answers in the end
 * @param onNotStored takes back what was reserved for it
 */
record RegistrationReply(
    ActorRef<StatusReply<Answer<RobotView>>> replyTo,
    Consumer<RobotRecord> onStored,
    Runnable onNotStored)
    implements RobotRegistrar.Listener {

  @Override
  public void stored(RobotRecord robot) {
    onStored.accept(robot);
  }

  @Override
  public void rejected(Answer<RobotView> why) {
    onNotStored.run();
    replyTo.tell(StatusReply.success(why));
  }

  @Override
  public void failed(StoreException e) {
    onNotStored.run();
    replyTo.tell(
        StatusReply.error(
            e.isRefusal()
                ? e
                : new StoreException(
                    "The database does not answer, so the robot was not stored; try again.", e)));
  }
}
