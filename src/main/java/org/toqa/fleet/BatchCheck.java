package org.toqa.fleet;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.toqa.fleet.BatchAnswer.Refusal;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/**
 * Checks many orders at once. Their ways take time, so that is done on a thread of its own.
 *
 * @param check that no other thread uses
 * @param together what all robots carry together, kilograms
 */
record BatchCheck(
    OrderCheck check, List<TaskOrder> orders, String user, Instant now, double together) {

  /**
   * @param tasks of the orders that are good; their ids are not known yet
   */
  record Result(List<TransportTask> tasks, List<Refusal> refusals) {}

  Result run() {
    List<TransportTask> tasks = new ArrayList<>();
    List<Refusal> refusals = new ArrayList<>();
    for (int place = 0; place < orders.size(); place++) {
      Answer<TransportTask> checked = check.task(orders.get(place), user, now, together);
      switch (checked) {
        case Answer.Accepted<TransportTask>(TransportTask task) -> tasks.add(task);
        case Answer.Refused<TransportTask>(String field, Sentence sentence) ->
            refusals.add(new Refusal(place, field, sentence));
        case Answer.Conflict<TransportTask>(Sentence sentence, var needs) ->
            refusals.add(new Refusal(place, null, sentence));
        case Answer.Unknown<TransportTask>(Sentence sentence) ->
            refusals.add(new Refusal(place, null, sentence));
      }
    }
    return new Result(tasks, refusals);
  }
}
