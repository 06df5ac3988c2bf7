package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.Tally;

/**
 * Wherever somebody gives the server a word he gives it every attack, with all else as it should
 * be, while the fleet carries tasks; each attack has the one right answer. A sample gives each word
 * a sixth of the attacks, {@code -Dtoqa.attacks=whole} all. Forged forms are in {@code AccessTest},
 * planted sessions and guessed passwords in {@code LoginTest}, very many connections in {@code
 * CrowdTest}.
 */
@Tag("full")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class AttacksTest {
  private AttackRun run;

  @BeforeAll
  void start(@TempDir Path data) throws Exception {
    run = new AttackRun(data);
  }

  /** Whatever was sent, the fleet still carries, and no secret is in the log. */
  @AfterAll
  void stop() throws Exception {
    try (AttackRun ended = run) {
      ended.freeRobots();
      ended.tasks().awaitDone();
      Tally.add("attack strings", ended.tried());
    }
  }

  @Test
  void whatIsTypedIsTextInEveryFieldOfEveryForm() throws Exception {
    FormAttacks forms = new FormAttacks(run);
    int before = run.tried();
    forms.attack();
    run.assertNoFaults();
    assertTrue(run.tried() - before > 400, "only " + (run.tried() - before) + " attacks");
    forms.readPages();
    run.assertNoFaults();
  }

  @Test
  void everyFieldOfEveryFormIsAttacked() throws InterruptedException {
    assertEquals(List.of(), new FormAttacks(run).left());
  }

  @Test
  void whatIsSaidIsTextInEveryWordOfEveryOrder() throws Exception {
    int before = run.tried();
    new OrderAttacks(run).attack();
    run.assertNoFaults();
    assertTrue(run.tried() - before > 300, "only " + (run.tried() - before) + " attacks");
  }

  @Test
  void everyWordOfEveryOrderIsAttacked() {
    assertEquals(OrderAttacks.described(run), OrderAttacks.attacked());
  }

  @Test
  void whatIsAskedIsTextInEveryQuery() throws Exception {
    int before = run.tried();
    new QueryAttacks(run).attack();
    run.assertNoFaults();
    assertTrue(run.tried() - before > 200, "only " + (run.tried() - before) + " attacks");
  }

  @Test
  void everyQueryIsAttacked() {
    assertEquals(QueryAttacks.described(run), QueryAttacks.attacked());
  }
}
