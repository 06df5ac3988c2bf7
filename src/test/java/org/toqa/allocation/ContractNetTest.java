package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.Auction.Bid;
import org.toqa.allocation.Auction.Refusal;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class ContractNetTest {

  @Test
  void theLeastBidWins() {
    // 88.8 J/m: 2 m and 1 m with the load are 266 J, 5 m and 1 m 533 J
    assertEquals(
        List.of(
            new Decision.Assigned(
                1,
                List.of("r2"),
                Sentence.verbatim("the lowest of 3 bids, 0.3 kJ; next was r1 with 0.5 kJ"))),
        Outcome.inEnglish(
            new ContractNet()
                .allocate(
                    situation(
                        List.of(job(1, 0, 10)),
                        List.of(free("r1", 0, 5), free("r2", 0, 8), free("r3", 0, 30))))));
  }

  @Test
  void anAuctionIsOverWhenAllHaveAnsweredOrTheTimeIs() {
    Auction auction = new Auction(Set.of("r1", "r2", "r3"), NOON.plusMillis(500));

    assertTrue(auction.receive(new Bid("r1", 9, NOON.plusMillis(10))));
    assertTrue(auction.receive(new Refusal("r2", NOON.plusMillis(20))));
    assertFalse(auction.isOver(NOON.plusMillis(500)));
    assertEquals(Set.of("r3"), auction.silent());
    assertTrue(auction.isOver(NOON.plusMillis(501)));
    assertFalse(auction.receive(new Bid("r3", 1, NOON.plusMillis(501))), "too late");
    assertEquals(Optional.of(new Bid("r1", 9, NOON.plusMillis(10))), auction.winner());
  }

  @Test
  void anAnswerCountsOnceAndFromTheInvitedOnly() {
    Auction auction = new Auction(Set.of("r1"), NOON.plusMillis(500));

    assertFalse(auction.receive(new Bid("unasked", 1, NOON)));
    assertTrue(auction.receive(new Bid("r1", 9, NOON)));
    assertFalse(auction.receive(new Bid("r1", 2, NOON)), "a second bid");
    assertTrue(auction.isOver(NOON));
    assertEquals(Optional.of(new Bid("r1", 9, NOON)), auction.winner());
  }

  @Test
  void aSilentRobotIsLeftOutAlsoOfTheExchange() {
    Bidding withoutR2 =
        (problem, job, invited) ->
            Bidding.computedReplies(problem, job, invited).stream()
                .filter(reply -> !reply.robot().equals("r2"))
                .toList();

    // 10 m and 1 m with the load: 977 J
    assertEquals(
        List.of(
            new Decision.Assigned(
                1, List.of("r1"), Sentence.verbatim("the only bid, 1.0 kJ; no answer from r2"))),
        Outcome.inEnglish(
            new ContractNet(withoutR2)
                .allocate(
                    situation(
                        List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9))))));
  }

  @Test
  void robotsExchangeTasksWhereThatIsCheaperInAll() {
    // in turn: r2 to task 1 (2 m), r1 to task 2 (9 m); exchanged: 4 m and 3 m
    assertEquals(
        List.of(exchanged(1, "r2", "r1"), exchanged(2, "r1", "r2")),
        new ContractNet()
            .allocate(
                situation(
                    List.of(job(1, 5, 4), job(2, 5, 9)),
                    List.of(free("r1", 5, 0), free("r2", 5, 6)))));
  }

  @Test
  void aTaskGivenOutGoesToARobotThatIsNearer() {
    List<Decision> decisions =
        new ContractNet()
            .allocate(
                situation(
                    NOON,
                    List.of(job(2, 9, 70)), // too heavy, but announced to r2
                    List.of(new GivenTask(job(1, 5, 10), "r1")),
                    List.of(busy("r1", 5, 5, 1), free("r2", 5, 9))));

    assertEquals(exchanged(1, "r1", "r2"), decisions.getLast());
  }

  private static Decision exchanged(long task, String from, String to) {
    return new Decision.Assigned(task, List.of(to), Phrase.TAKEN_IN_EXCHANGE.with(from));
  }
}
