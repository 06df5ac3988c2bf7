package org.toqa.fleet.manager;

import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.dispatch.ControlMessage;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Hold;
import org.toqa.fleet.OperatorHold;
import org.toqa.fleet.dispatch.FloorFleet;

/** What the manager agent is told. */
sealed interface ManagerMessage {

  /** A person pauses all robots, or lets them go on. It overtakes what came before it. */
  record SetPause(boolean pause, String user, ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo)
      implements ManagerMessage, ControlMessage {}

  /** It comes before what is asked afterwards. */
  record ResumeEnded(OperatorHold.ResumeEnded ended) implements ManagerMessage, ControlMessage {}

  /** A floor's agents have started; they may have been told of an older pause. */
  record FloorStarted(FloorFleet floor) implements ManagerMessage, ControlMessage {}
}
