package org.toqa.fleet;

import java.util.function.Consumer;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.FleetStore.StoreException;

/**
 * Who wished for a robot, and waits for the answer.
 *
 * @param whenStored goes on with the robot, and answers in the end
 * @param whenNot takes back what was reserved for it
 */
record RobotAsker(
    ActorRef<StatusReply<Answer<RobotView>>> replyTo,
    Consumer<RobotRecord> whenStored,
    Runnable whenNot)
    implements RobotIntake.Asker {

  @Override
  public void stored(RobotRecord robot) {
    whenStored.accept(robot);
  }

  @Override
  public void refused(Answer<RobotView> why) {
    whenNot.run();
    replyTo.tell(StatusReply.success(why));
  }

  @Override
  public void failed(StoreException e) {
    whenNot.run();
    replyTo.tell(
        StatusReply.error(
            new StoreException(
                "The database does not answer, so the robot was not stored; try again.", e)));
  }
}
