package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.toqa.allocation.Floors.NOON;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.NegotiationMessage.Bids;
import org.toqa.allocation.NegotiationMessage.CallForBids;
import org.toqa.allocation.NegotiationMessage.Confirmation;
import org.toqa.allocation.NegotiationMessage.Proposal;
import org.toqa.wording.Sentence;

class NegotiationTest {
  private final NegotiatedAllocator net = new NegotiatedAllocator();

  @Test
  void theLeastBidWins() {
    // 88.8 J/m: 2 m and 1 m with the load are 266 J, 5 m and 1 m 533 J
    assertEquals(
        List.of(given(1, "r2", "the lowest of 3 bids, 0.3 kJ; next was r1 with 0.5 kJ")),
        allocate(
            situation(
                List.of(job(1, 0, 10)),
                List.of(free("r1", 0, 5), free("r2", 0, 8), free("r3", 0, 30)))));
    assertEquals(
        List.of(
            "1: Announced to 3 robots; bids: r2 0.3 kJ, r1 0.5 kJ, r3 1.9 kJ",
            "1: Awarded to r2, confirmed",
            "1: r2, which has it for 0.3 kJ, offers it to others; bids: r1 0.5 kJ, r3 1.9 kJ"),
        net.lines);
    assertEquals(Duration.ZERO, net.lasted, "nothing is waited for where all answer");
  }

  @Test
  void whoDeclinesSaysWhy() {
    allocate(situation(List.of(job(1, 4, 10)), List.of(free("weak", 3, 9), free("r1", 5, 0))));

    assertEquals(
        "1: Announced to 2 robots; bids: r1 1.0 kJ; declined: weak cannot carry this load",
        net.lines.getFirst());
  }

  @Test
  void aSilentRobotIsWaitedForOnceAndLeftOut() {
    net.with("r2", (message, own) -> Optional.empty());

    // 10 m and 1 m with the load: 977 J
    assertEquals(
        List.of(given(1, "r1", "the only bid, 1.0 kJ; no answer from r2")),
        allocate(situation(List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9)))));
    assertEquals("1: Announced to 2 robots; bids: r1 1.0 kJ; no answer: r2", net.lines.getFirst());
    assertEquals(Negotiation.ANSWER_TIME.plusMillis(1), net.lasted);
  }

  @Test
  void whatComesLateTwiceUnaskedOrOfAnotherNegotiationCountsForNothing() {
    Negotiation negotiation =
        new Negotiation(
            7,
            situation(List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9))),
            true);
    CallForBids call = (CallForBids) negotiation.begin(NOON).getFirst().message();
    Quote cheap = Quote.possible(1, 1);
    assertTrue(negotiation.receive(bids("r9", 7, call.call(), cheap), NOON).isEmpty(), "unasked");
    assertTrue(negotiation.receive(bids("r2", 6, call.call(), cheap), NOON).isEmpty(), "another");
    assertTrue(negotiation.receive(bids("r2", 7, 99, cheap), NOON).isEmpty(), "another call");
    Quote dear = Quote.possible(1, 900);
    assertTrue(
        negotiation.receive(bids("r1", 7, call.call(), dear), NOON).isEmpty(), "r2 is missed");
    assertTrue(negotiation.receive(bids("r1", 7, call.call(), cheap), NOON).isEmpty(), "twice");

    List<Negotiation.Outgoing> awards =
        negotiation.receive(bids("r2", 7, call.call(), cheap), NOON.plusSeconds(2));

    assertEquals(List.of("r1"), awards.stream().map(Negotiation.Outgoing::robot).toList(), "late");
  }

  private static Bids bids(String robot, long negotiation, int call, Quote quote) {
    return new Bids(robot, negotiation, call, Map.of(1L, quote));
  }

  @Test
  void anAwardThatIsRefusedComesBackAndIsAnnouncedAgain() {
    net.with(
        "r2",
        (message, own) ->
            Optional.of(
                message instanceof Proposal p
                    ? new Confirmation("r2", 1, p.deal(), Sentence.verbatim("has a flat tyre"))
                    : Bidder.answer(message, own)));

    assertEquals(
        List.of(given(1, "r1", "the only bid, 1.0 kJ; declined by r2")),
        allocate(situation(List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9)))));
    assertEquals(
        List.of(
            "1: Announced to 2 robots; bids: r2 0.2 kJ, r1 1.0 kJ",
            "1: The award came back: r2 has a flat tyre",
            "1: Announced to 1 robot; bids: r1 1.0 kJ",
            "1: Awarded to r1, confirmed"),
        net.lines);
  }

  @Test
  void anAwardThatIsNotAnsweredComesBackToo() {
    net.with(
        "r2",
        (message, own) ->
            message instanceof Proposal
                ? Optional.empty()
                : Optional.of(Bidder.answer(message, own)));

    assertEquals(
        List.of("r1"),
        Outcome.robots(
            allocate(situation(List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9))))
                .getFirst()));
  }

  @Test
  void aTaskThatNobodyTakesWaitsAndSaysWhatEachSaid() {
    net.with("r1", (message, own) -> Optional.empty());

    Decision decision =
        allocate(situation(List.of(job(1, 4, 10)), List.of(free("r1", 5, 0)))).getFirst();

    assertEquals("The only robot, r1, has not answered in time.", decision.reason().english());
  }

  @Test
  void whatAStrangeAgentSaysIsNoBid() {
    net.with(
        "r2",
        (message, own) ->
            Optional.of(
                message instanceof CallForBids call
                    ? new Bids(
                        "r2",
                        1,
                        call.call(),
                        Map.of(1L, Quote.possible(1, Double.NaN), 99L, Quote.possible(0, -5)))
                    : Bidder.answer(message, own)));

    allocate(situation(List.of(job(1, 0, 10)), List.of(free("r1", 0, 0), free("r2", 0, 9))));

    assertEquals(
        "1: Announced to 2 robots; bids: r1 1.0 kJ; declined: r2 makes no proper bid",
        net.lines.getFirst());
  }

  @Test
  void twoRobotsChangeTasksWhereThatIsCheaper() {
    // in turn: r2 to task 1 (2 m), r1 to task 2 (9 m); exchanged: 4 m and 3 m, 4 m less
    List<Decision> decisions =
        allocate(
            situation(
                List.of(job(1, 5, 4), job(2, 5, 9)), List.of(free("r1", 5, 0), free("r2", 5, 6))));

    assertEquals(List.of("r1"), Outcome.robots(decisions.getFirst()));
    assertEquals(List.of("r2"), Outcome.robots(decisions.getLast()));
    assertTrue(net.lines.getLast().endsWith("r1, r2 trade tasks and save 0.4 kJ together"));
  }

  /** Each of three robots is 20 m from its own task, and beside that of the next one. */
  private static AllocationProblem ring() {
    return situation(
        NOON,
        List.of(),
        List.of(
            new GivenTask(job(1, 1, 30), "r1"),
            new GivenTask(job(2, 1, 50), "r2"),
            new GivenTask(job(3, 1, 10), "r3")),
        List.of(busy("r1", 5, 10, 1), busy("r2", 5, 30, 2), busy("r3", 5, 50, 3)));
  }

  @Test
  void threeRobotsPassTheirTasksOnRoundARing() {
    List<Decision> decisions = allocate(ring());

    assertEquals(
        List.of(List.of("r2"), List.of("r3"), List.of("r1")),
        decisions.stream().map(Outcome::robots).toList());
    // together 20 + 20 + 40 m less, a third of it for each
    assertEquals(3, net.lines.stream().filter(l -> l.contains("and save 7.1 kJ")).count());
  }

  @Test
  void aChainOfSalesFreesTheOneThatOnlyCanDoWhatStillWaits() {
    // only the strong one can take task 9, and it has task 1, which r2 can do
    List<Decision> decisions =
        allocate(
            situation(
                NOON,
                List.of(job(9, 8, 12)),
                List.of(new GivenTask(job(1, 1, 40), "strong")),
                List.of(busy("strong", 10, 10, 1), free("r2", 5, 41))));

    assertEquals(List.of("strong"), Outcome.robots(decisions.getFirst()));
    assertEquals(List.of("r2"), Outcome.robots(decisions.getLast()));
  }

  @Test
  void aTradeThatOneRefusesIsVoidAsAWhole() {
    net.with(
        "r3",
        (message, own) ->
            Optional.of(
                message instanceof Proposal p
                    ? new Confirmation("r3", 1, p.deal(), Sentence.verbatim("does not want to"))
                    : Bidder.answer(message, own)));

    List<Decision> decisions = allocate(ring());

    assertFalse(decisions.stream().anyMatch(d -> Outcome.robots(d).contains("r3")));
    assertTrue(net.lines.contains("3: A trade fell through: r3 does not want to"));
  }

  @Test
  void pricesShareWhatIsSavedEvenly() {
    ReceivedQuotes quotes =
        new ReceivedQuotes(new Costs(situation(List.of(), List.of()).terrain()));
    quotes.put("a", 1, Quote.possible(0, 900));
    quotes.put("b", 1, Quote.possible(0, 200));
    quotes.put("b", 2, Quote.possible(0, 500));
    quotes.put("c", 2, Quote.possible(0, 300));
    quotes.put("a", 2, Quote.possible(0, 5000));
    quotes.put("c", 1, Quote.possible(0, 5000));

    Trade chain =
        new Market(Map.of(1L, "a", 2L, "b"), List.of("a", "b", "c"), quotes).clear().getFirst();

    // 900 + 500 - 200 - 300 = 900, 300 for each of three
    assertEquals(900, chain.saved(), 1e-9);
    assertEquals(-600, chain.income("a"), 1e-9); // it is rid of 900
    assertEquals(0, chain.income("b"), 1e-9); // paid 600, pays 600; 500 - 200 = 300 gained
    assertEquals(600, chain.income("c"), 1e-9); // which costs it 300
  }

  private List<Decision> allocate(AllocationProblem problem) {
    return Outcome.inEnglish(net.allocate(problem));
  }

  private static Decision given(long task, String robot, String why) {
    return new Decision.Assigned(task, List.of(robot), Sentence.verbatim(why));
  }
}
